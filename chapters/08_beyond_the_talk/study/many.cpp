// Many springs and many bodies: what one of them costs, from a hundred to a million.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <thread>
#include <vector>

#ifdef __linux__
#include <unistd.h>
#endif

#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/rigid/many_bodies.hpp>
#include <timestep/parallel_for.hpp>
#include <timestep/springs.hpp>

#include "random_body.hpp"
#include "sections.hpp"
#include "timing.hpp"

using namespace timestep;

namespace {

constexpr std::size_t most = 1000000;
constexpr long several = 32;  // steps a pass over memory
constexpr float h = 1.0f / 60;
using Pack = Lanes<float>;
constexpr std::size_t lanes = Pack::lanes;

// One way to step the first `count` of all; `steps` of each in a pass.
struct Way {
    std::string key;
    std::function<void(std::size_t count)> pass;
    long steps = 1;
    double nanoseconds = 0;  // a step of one, for the count that is measured
};

// In turns; the fastest turn is the one that nothing disturbed.
void measure(std::vector<Way>& ways, std::size_t count) {
    for (Way& way : ways) way.nanoseconds = 1e9;
    const long passes = std::max(1l, long(20000 / count));
    for (int turn = 0; turn < 2; ++turn)
        for (Way& way : ways) {
            const double seconds = lab::seconds_of([&] {
                for (long i = 0; i < passes; ++i) way.pass(count);
            });
            const double steps = double(passes) * double(way.steps) * double(count);
            way.nanoseconds = std::min(way.nanoseconds, 1e9 * seconds / steps);
        }
}

// The whole range, into a data file; afterwards the ways hold the times of `told`, one of its
// sizes. The range is gone through three times, and the fastest of each counts: a disturbance that
// lasts seconds must not stand in the picture. Returns the count from which on the last way is
// faster than the second, by a twentieth or more; 0: none.
std::size_t measure_all(std::vector<Way>& ways, lab::Table& table, double told) {
    const double sizes[] = {1e2, 2e2, 5e2, 1e3, 2e3, 5e3, 1e4, 2e4, 5e4, 1e5, 2e5, 5e5, 1e6};
    std::map<double, std::vector<double>> fastest;
    for (int round = 0; round < 3; ++round)
        for (const double size : sizes) {
            measure(ways, std::size_t(size));
            std::vector<double>& best = fastest[size];
            best.resize(ways.size(), 1e9);
            for (std::size_t i = 0; i < ways.size(); ++i) best[i] = std::min(best[i], ways[i].nanoseconds);
        }
    std::size_t from = 0;
    for (const double size : sizes) {
        std::vector<lab::Cell> row{size};
        for (std::size_t i = 0; i < ways.size(); ++i) row.push_back(fastest[size][i]);
        table.row(row);
        if (fastest[size].back() > 0.95 * fastest[size][1])
            from = 0;
        else if (from == 0)
            from = std::size_t(size);
    }
    for (std::size_t i = 0; i < ways.size(); ++i) ways[i].nanoseconds = fastest[told][i];
    return from;
}

// Two hundred throws at 10 rad/s and 60 Hz, turned by the new ω as in a pack: the worst orientation
// in two seconds, or the share that is lost.
using Turn = std::function<RigidState<double>(const Body&, const RigidState<double>&, double h)>;
std::string error_in_a_pack(const Turn& turn, const Body& inertia) {
    RandomBody random(13);
    const int throws = 200;
    double worst = 0, lost = 0;
    for (int k = 0; k < throws; ++k) {
        const Spin start = spinning(10 * random.direction());
        const Exact exact(inertia, start);
        RigidState<double> s = in_world(start);
        double error = 0;
        for (int n = 1; n <= 120; ++n) {
            s = turn(inertia, s, 1.0 / 60);
            if (n % 4 == 0) error = larger(error, apart(s.q, exact(s.t).q));
        }
        worst = larger(worst, error), lost += error > 0.5 ? 100.0 / throws : 0;
    }
    char text[32];
    if (worst > 0.5)
        std::snprintf(text, sizeof text, "%.0f of %d lost", lost * throws / 100, throws);
    else
        std::snprintf(text, sizeof text, "%.0f\u00a0%%", 100 * worst);
    return text;
}

// How many bytes the cache of this level, 1 to 3, holds; 0 or less where that is not known.
double cache_bytes([[maybe_unused]] int level) {
#ifdef _SC_LEVEL3_CACHE_SIZE
    const int names[] = {_SC_LEVEL1_DCACHE_SIZE, _SC_LEVEL2_CACHE_SIZE, _SC_LEVEL3_CACHE_SIZE};
    return double(sysconf(names[level - 1]));
#else
    return 0;
#endif
}

// The caches, and how many springs and bodies each of them holds.
void caches(double spring_bytes, double body_bytes, lab::Findings& out) {
    auto& table = out.table("many_caches.tsv", {"name", "springs", "bodies"});
    const char* const names[] = {"level-1 cache", "level-2", "level-3"};
    for (int level = 1; level <= 3; ++level)
        if (const double bytes = cache_bytes(level); bytes > 0)
            table.row({std::string(names[level - 1]), bytes / spring_bytes, bytes / body_bytes});
    table.row({std::string(" "), 1.0, 1.0});  // where nothing is known: left of the picture
}

std::string times(double ratio) {
    char text[24];
    std::snprintf(text, sizeof text, "%.2g times", ratio);
    return text;
}

void many_springs(lab::Findings& out) {
    std::vector<Spring<float>> alone;
    std::vector<State<float>> states;
    Springs<float> once, often;
    for (std::size_t i = 0; i < most; ++i) {
        const float x = 1 + float(i % 7);
        alone.emplace_back(1 + float(i % 100) / 10);
        states.push_back({0, x, 0});
        once.add(alone.back(), x, 0), often.add(alone.back(), x, 0);
    }
    const auto packs = [](std::size_t count) { return (count + lanes - 1) / lanes; };
    std::vector<Way> ways{
        {"one_by_one",
         [&](std::size_t count) {
             for (std::size_t i = 0; i < count; ++i) states[i] = semi_implicit_euler.step(alone[i], states[i], h);
         }},
        {"lanes", [&](std::size_t count) { once.step(semi_implicit_euler, h, 1, 0, packs(count)); }},
        {"several", [&](std::size_t count) { often.step(semi_implicit_euler, h, several, 0, packs(count)); }, several}};
    for (Way& way : ways)
        for (long n = 0; n < several; n += way.steps) way.pass(most);
    bool same = true;
    for (std::size_t i = 0; i < most; ++i) same = same && states[i].x == once[i].x && states[i].x == often[i].x;
    out.check("many_springs_same", same,
              "a million springs: one by one, in lanes and many steps a pass agree to the last bit");

    auto& table = out.table("many_springs.tsv", {"count", "one_by_one", "lanes", "several"});
    measure(ways, 1000);
    const double one_pass_ns = ways[1].nanoseconds, many_steps_ns = ways[2].nanoseconds;
    measure_all(ways, table, most);
    const double alone_ns = ways[0].nanoseconds, lanes_ns = ways[1].nanoseconds, several_ns = ways[2].nanoseconds;
    std::printf("a million springs, ns a step: %.2f one by one, %.2f in lanes,\n", alone_ns, lanes_ns);
    std::printf("    and %.3f in lanes with %ld steps a pass\n", several_ns, several);
    out.number("many_lanes", double(lanes), "", "numbers of type float in a pack");
    out.number("many_springs_lanes", alone_ns / lanes_ns, "",
               "a million springs: in lanes, times as fast as one by one", 2);
    const double memory = several_ns / many_steps_ns, memory_once = lanes_ns / one_pass_ns;
    const std::string pass = "With " + std::to_string(several) + " steps a pass over the memory ";
    const std::string felt = memory < 1.5 && memory_once > 2 * memory
                                 ? "a spring among a million costs about what one among a thousand "
                                   "does, so the memory is hardly felt"
                                 : "in this run a step of one among a million took " +
                                       (memory < 1.05 ? "" : times(memory) + " ") +
                                       "as long as of one among a thousand";
    out.text("many_memory",
             several_ns > lanes_ns
                 ? "At a million springs something disturbed the curve with " + std::to_string(several) +
                       " steps a pass: that point tells nothing"
                 : pass + "they are " + times(alone_ns / several_ns) + " as fast as one by one: " + felt,
             "what the memory costs, in this run");
}

void many_bodies(lab::Findings& out) {
    struct Member {
        PrincipalInertia<float> inertia;
        RigidState<float> state;
    };
    std::vector<Member> boxes;
    ManyBodies<float, UniformInertia, PrincipalInertia> all, shared;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> side(0.5f, 2), number(-5, 5);
    // A thousand boxes, over and over: to make a million costs more than to step them.
    for (std::size_t i = 0; i < most; ++i) {
        if (i < 1000) {
            const Vector3<float> omega(number(random), number(random), number(random));
            const float a = side(random), b = side(random), c = side(random);
            boxes.push_back({box(10.0f, a, b, c), {0, Quaternion<float>::Identity(), omega}});
        } else {
            const Member again = boxes[i % 1000];
            boxes.push_back(again);
        }
        all.add(boxes.back().inertia, boxes.back().state.q, boxes.back().state.omega);
    }
    const UniformInertia<float> ball = sphere(1.0f, 1.0f);
    for (std::size_t i = 0; i < most; ++i) all.add(ball, boxes[i].state.q, boxes[i].state.omega);

    auto& packs = all.packs<PrincipalInertia>();
    auto& balls = all.packs<UniformInertia>();
    const auto some = [](auto& of, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) of[i].step(half_step_jacobian, h);
    };
    const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 2u, 4u);
    std::vector<Way> ways{{"one_by_one",
                           [&](std::size_t count) {
                               for (std::size_t i = 0; i < count; ++i)
                                   boxes[i].state =
                                       step_rotation(half_step_jacobian, boxes[i].inertia, boxes[i].state, h);
                           }},
                          {"lanes", [&](std::size_t count) { some(packs, 0, (count + lanes - 1) / lanes); }},
                          {"balls", [&](std::size_t count) { some(balls, 0, (count + lanes - 1) / lanes); }}};
    for (Way& way : ways) way.pass(most);
    double worst = 0;
    for (std::size_t i = 0; i < 1000; ++i) {
        const RigidState<float> packed = all.state<PrincipalInertia>(i);
        const Vector3<float> off = packed.omega - boxes[i].state.omega;
        worst = std::max(worst, double(off.norm()));
        worst = std::max(worst, double((packed.q.coeffs() - boxes[i].state.q.coeffs()).norm()));
    }
    out.check("many_bodies_same", worst < 1e-5, "boxes: one by one and in lanes agree, but for the last roundings");

    ways.push_back({"threads", [&](std::size_t count) {
                        parallel_for((count + lanes - 1) / lanes, threads,
                                     [&](std::size_t a, std::size_t b) { some(packs, a, b); });
                    }});
    auto& table = out.table(
        "many_bodies.tsv", {"count", "one_by_one", "lanes", "balls", "lanes, " + std::to_string(threads) + " threads"});
    const std::size_t pays = measure_all(ways, table, 1e4);
    out.text("many_threads_pay",
             pays == 0 || pays == most  // one lucky point is no range
                 ? "in this run they have not paid for good, up to a million bodies"
                 : "in this run they pay from " + std::to_string(pays) + " bodies on",
             "where threads pay");
    double start_ns = 1e9;  // to start and join threads that do nothing; the fastest, as of all other times
    for (int i = 0; i < 101; ++i)
        start_ns = std::min(
            start_ns, 1e9 * lab::seconds_of([&] { parallel_for(threads, threads, [](std::size_t, std::size_t) {}); }));
    const auto in_lanes = [&](const auto& solver) {
        return [&, solver](std::size_t count) {
            for (std::size_t i = 0; i < (count + lanes - 1) / lanes; ++i) packs[i].step(solver, h);
        };
    };
    std::vector<Way> others{{"passive", in_lanes(passive_gyroscopic)}, {"cayley", in_lanes(cayley_gyroscopic)}};
    double passive_ns = 1e9, cayley_ns = 1e9;
    for (int round = 0; round < 3; ++round) {
        measure(others, 10000);
        passive_ns = std::min(passive_ns, others[0].nanoseconds),
        cayley_ns = std::min(cayley_ns, others[1].nanoseconds);
    }
    out.number("lanes_passive_ns", passive_ns, "ns", "passive, in lanes", 2);
    out.number("lanes_cayley_ns", cayley_ns, "ns", "Cayley, in lanes", 2);
    const Body brick = box(12.0, 1.0, 2.0, 3.0), ruler = box(0.05, 1.0, 0.1, 0.02);
    const auto errors = [&](const std::string& id, const auto& solver) {
        const Turn turned = [=](const Body& inertia, const RigidState<double>& s, double step) {
            return step_rotation(solver, inertia, s, step);
        };
        out.text("lanes_" + id + "_box", error_in_a_pack(turned, brick),
                 "box, 10 rad/s, turned by the new omega: worst orientation, or share of throws lost");
        out.text("lanes_" + id + "_ruler", error_in_a_pack(turned, ruler), "a ruler, the same");
    };
    errors("passive", passive_gyroscopic);
    errors("half_step", half_step_jacobian);
    errors("cayley", cayley_gyroscopic);
    const double alone_ns = ways[0].nanoseconds, lanes_ns = ways[1].nanoseconds, balls_ns = ways[2].nanoseconds;
    std::printf("ten thousand boxes, ns a step: %.1f one by one, %.1f in lanes; a ball %.1f\n", alone_ns, lanes_ns,
                balls_ns);
    std::printf("    by the passive step in lanes %.1f, by Cayley %.1f\n", passive_ns, cayley_ns);
    out.number("many_bodies_ratio", alone_ns / lanes_ns, "",
               "ten thousand boxes: in lanes, times as fast as one by one", 2);
    out.number("many_box_ns", lanes_ns, "ns", "a step of a box among ten thousand, in lanes", 2);
    out.number("many_ball_ns", balls_ns, "ns", "a step of a ball among ten thousand, in lanes", 2);
    const double start_boxes = 100 * std::round(start_ns / lanes_ns / 100);
    out.number("many_threads_start", start_boxes, "",
               "boxes that are stepped in lanes while the threads start, at best");
    out.number("many_threads_least", start_boxes * threads / (threads - 1), "",
               "boxes of which the other threads' share takes as long as that");
    out.number("many_threads", double(threads), "", "threads of the curve with several");
}

}  // namespace

void many(const Settings&, lab::Findings& out) {
    out.section("Many bodies");
    std::printf("a pack holds %zu numbers of type float\n", lanes);
    many_springs(out);
    many_bodies(out);
    caches(sizeof(Spring<Pack>) / double(lanes) + 2 * sizeof(float),
           sizeof(BodyPack<PrincipalInertia<Pack>>) / double(lanes), out);
}
