// I13: the advice on every kind of spring, at random questions, held to runs of the library's own methods.
#include <catch2/catch_test_macros.hpp>

#include <string>

#include "method_on_spring.hpp"

#include "random_springs.hpp"

using namespace timestep;
using springs::Random;

namespace {

struct Tally {
    long right = 0, wrong = 0, close = 0, open = 0, near = 0, open_grew = 0, open_stayed = 0;
    void count(Verdict said, bool grew) {
        close += said == Verdict::too_close_to_call;
        open += said == Verdict::not_proven;
        open_grew += said == Verdict::not_proven && grew, open_stayed += said == Verdict::not_proven && !grew;
        if (said == Verdict::stable || said == Verdict::grows) ((said == Verdict::grows) == grew ? right : wrong)++;
    }
};

// `visit(method)` for one method drawn at random; with a damper for one that takes it.
template <class Visit>
void one_method(Random& random, bool damped, const Visit& visit) {
    int count = 0;
    for_each_spring_method([&](const auto& method) { count += !damped || method.takes_damping; });
    const int chosen = random.below(count);
    int i = 0;
    for_each_spring_method([&](const auto& method) {
        if (damped && !method.takes_damping) return;
        if (i++ == chosen) visit(method);
    });
}

// A step for a scene: one in three within a tenth of a boundary, of the fastest swing that can be or of the slowest.
double a_step(Random& random, const SpringScene& scene, const MethodOnSpring& method, Tally& tally) {
    const bool least = random.below(2);
    const double limit = least ? method.least_limit.value : method.limit.value;
    if (random.below(3) || !(limit > 0.02 && limit < 1e3)) return random.in_log(0.05, 10) / scene.fastest.omega;
    ++tally.near;
    return limit * random.even(0.9, 1.1) / (least ? scene.least : scene.fastest).omega;
}

// A scene, drawn by `draw`: what is typed about it, and the net itself.
template <class Draw>
Tally ask(unsigned seed, long questions, const Draw& draw) {
    Random random(seed);
    Tally tally;
    for (long i = 0; i < questions; ++i) {
        const double damping = random.below(4) ? random.in_log(0.02, 4) : 0;
        auto drawn = draw(random);
        const Pull& pull = drawn.first;
        auto& net = drawn.second;
        const SpringScene scene = scene_of(pull, 1, damping);
        net.damping_share = damping;
        net.hold(1e-4 * pull.least);  // what is free drifts, and no run of steps tells that from a slow growth
        one_method(random, damping > 0, [&](const auto& method) {
            const auto judged = on_spring(method, scene.fastest.zeta, scene.least.zeta);
            const double h = a_step(random, scene, judged, tally);
            const Advice advice = at_step(judged, scene, h, 0.01);
            const bool grew = springs::grows(method, net, h);
            const long wrong = tally.wrong;
            tally.count(advice.verdict, grew);
            if (tally.wrong > wrong)
                UNSCOPED_INFO(method.name << ", zeta " << scene.fastest.zeta << ": " << advice.reason);
        });
    }
    return tally;
}

void holds(const Tally& tally, long questions, bool bounds) {
    CAPTURE(tally.right, tally.wrong, tally.close, tally.open, tally.open_grew, tally.open_stayed, tally.near);
    CHECK(double(tally.wrong) <= 0.001 * double(tally.right + tally.wrong));
    CHECK(double(tally.right) > 0.6 * double(questions));
    CHECK(double(tally.near) > 0.15 * double(questions));  // four methods of ten have no boundary, or none undamped
    if (bounds) CHECK((tally.open_grew > 0 && tally.open_stayed > 0));
}

const auto one_spring = [](Random& random) {
    const double mass = random.in_log(0.1, 10);
    springs::Net<1> net;
    net.masses << mass;
    net.add(1, springs::Net<1>::Vector(1));
    return std::pair(springs_on_body(mass, 1), net);
};
const auto on_a_body = [](Random& random) {
    const double mass = random.in_log(0.1, 10), arm = random.in_log(0.1, 3),
                 inertia = mass * arm * arm * random.even(0.1, 1);
    const int count = 1 + random.below(6);
    return std::pair(springs_on_body(mass, count, arm, inertia), springs::body(random, mass, count, arm, inertia));
};
const auto in_a_hinge = [](Random& random) {
    const double m1 = random.in_log(0.1, 10), m2 = random.in_log(0.1, 10), r1 = random.in_log(0.1, 3),
                 r2 = random.in_log(0.1, 3);
    const double I1 = m1 * r1 * r1 * random.even(0.1, 1), I2 = m2 * r2 * r2 * random.even(0.1, 1);
    return std::pair(hinge(m1, lightness(m1, r1, I1), m2, lightness(m2, r2, I2)),
                     springs::hinge(random, m1, r1, I1, m2, r2, I2));
};
const auto in_a_chain = [](Random& random) {
    const double mass = random.in_log(0.1, 10);
    return std::pair(springs_between(mass, 2), springs::points<1, 6>(random, mass));
};
const auto in_a_cloth = [](Random& random) {
    const double mass = random.in_log(0.1, 10);
    return std::pair(springs_between(mass, 4), springs::points<3, 3>(random, mass));
};

// A spring that lets go: taut at x > 0, and hung in a weight of `weight`.
struct OneSided {
    double zeta, weight;
    double acceleration(double x, double v) const { return weight - (x > 0 ? x + 2 * zeta * v : 0); }
    double slope_x(double x, double) const { return x > 0 ? -1 : 0; }
    double slope_v(double x, double) const { return x > 0 ? -2 * zeta : 0; }
    double energy(const State<double>& s) const { return s.v * s.v / 2 + (s.x > 0 ? s.x * s.x / 2 : 0) - weight * s.x; }
};

// "Stable": a bounce from anywhere never gets above its start. "Not proven": some gain, or that would say too much.
void check_tethers(long questions) {
    Random random(24);
    Tally tally;
    long gained = 0;
    for (long i = 0; i < questions; ++i) {
        const double zeta = random.below(4) ? random.in_log(0.02, 4) : 0;
        SpringScene scene(DampedSpring<double>(1, zeta));
        scene.only_pulls = true;
        one_method(random, true, [&](const auto& method) {
            if constexpr (std::decay_t<decltype(method)>::takes_damping &&
                          !std::is_same_v<std::decay_t<decltype(method)>, SemiImplicitEulerNewDamping>) {
                const auto judged = on_spring(method, zeta, zeta);
                const double h = a_step(random, scene, judged, tally);
                const Advice advice = at_step(judged, scene, h, 0.01);
                const OneSided tether{zeta, random.in_log(0.01, 1)};
                const double rest = tether.weight, bottom = rest * rest / 2;
                const State<double> start{0, rest * random.in_log(1.1, 30), 0};
                double most = 0;
                run(method, tether, start, h, 2000L,
                    [&](const auto& s) { most = std::max(most, tether.energy(s) + bottom); });
                const double first = tether.energy(start) + bottom;
                CAPTURE(method.name, zeta, h, advice.reason);
                if (advice.verdict == Verdict::stable) CHECK(most <= first * (1 + 1e-9));
                gained += advice.verdict == Verdict::not_proven && most > 4 * first;
            }
        });
    }
    CHECK(gained > 0);
}

// Frames drawn between the two lengths, or the shortest and the longest in a pattern: "stable" has to stand both.
template <class Method>
bool survives(const Method& method, double zeta, double shortest, double longest, Random& random, double growth,
              bool pattern) {
    const long steps = growth > 0 ? static_cast<long>(std::min(1e7, 60 / growth)) + 100 : 20'000;
    const int every = 1 + random.below(4);
    std::vector<StepMatrix<long double>> of;
    for (int i = 0; i <= 1000; ++i)
        of.push_back(detail::matrix_of(method, zeta, shortest + (longest - shortest) * i / 1000));
    double x = 0.8, v = 0.6, log_size = 0;
    for (long n = 0; n < steps; ++n) {
        const auto& a = of[static_cast<std::size_t>(pattern ? (n % (every + 1) ? 1000 : 0) : random.below(1001))];
        const double next = double(a.xx) * x + double(a.xv) * v;
        v = double(a.vx) * x + double(a.vv) * v, x = next;
        const double size = std::hypot(x, v);
        if (!(size > 1e-290)) return true;
        if (size > 1e100 || size < 1e-100) log_size += std::log(size), x /= size, v /= size;
    }
    const double expected = growth * double(steps);
    return log_size + std::log(std::hypot(x, v)) < (growth > 0 ? expected / 10 : std::log(100.0));
}

Tally ask_frames(long questions) {
    Random random(25);
    Tally tally;
    for (long i = 0; i < questions; ++i) {
        const double zeta = random.below(3) ? random.in_log(0.02, 4) : 0;
        one_method(random, zeta > 0, [&](const auto& method) {
            const auto judged = on_spring(method, zeta, zeta);
            SpringScene scene(DampedSpring<double>(1, zeta));
            scene.longest_frame = a_step(random, scene, judged, tally);
            scene.shortest_frame = scene.longest_frame * random.even(0.3, 0.95);
            const Advice advice = at_step(judged, scene, scene.longest_frame, 0.01);
            const auto& stepping = when_step_changes(method);
            const long wrong = tally.wrong;
            if (advice.verdict == Verdict::stable) {
                const bool stood =
                    survives(stepping, zeta, scene.shortest_frame, scene.longest_frame, random, 0, false) &&
                    survives(stepping, zeta, scene.shortest_frame, scene.longest_frame, random, 0, true);
                tally.count(advice.verdict, !stood);
            } else {
                const bool grows = advice.verdict == Verdict::grows;
                const double growth = grows ? std::max(1e-9, std::log(advice.growth_per_step)) : 0;
                const bool stood =
                    survives(stepping, zeta, scene.shortest_frame, scene.longest_frame, random, growth, false);
                tally.count(advice.verdict, !stood);
            }
            if (tally.wrong > wrong)
                UNSCOPED_INFO(method.name << ", zeta " << zeta << ", " << scene.shortest_frame << " to "
                                          << scene.longest_frame << " s: " << advice.reason);
        });
    }
    return tally;
}

void all_kinds(long questions) {
    holds(ask(19, questions, one_spring), questions, false);
    holds(ask(20, questions, on_a_body), questions, true);
    holds(ask(21, questions, in_a_hinge), questions, true);
    holds(ask(22, questions, in_a_chain), questions, true);
    holds(ask(23, questions, in_a_cloth), questions, true);
    check_tethers(questions);
    const Tally frames = ask_frames(questions);
    CAPTURE(frames.right, frames.wrong, frames.open, frames.open_grew, frames.open_stayed, frames.close);
    CHECK(double(frames.wrong) <= 0.001 * double(frames.right + frames.wrong));
    CHECK(double(frames.right) > 0.7 * double(questions));
}

}  // namespace

TEST_CASE("the verdicts on every kind of spring are those of runs", "[library][I13]") { all_kinds(300); }

TEST_CASE("of ten thousand questions of each kind of spring 99.9 % of the verdicts are right",
          "[library][I13][long][proof]") {
    all_kinds(10'000);
}
