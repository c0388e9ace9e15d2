// Six ways to fool oneself with a stopwatch, each done on purpose.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"
#include "timing.hpp"

using namespace timestep;

namespace {

constexpr double h = 1.0 / 60;
const State start{0, 1.0, 0.0};
volatile double sink;

template <class Work>
double nanoseconds(const Work& work) {
    return 1e9 * lab::seconds_of(work);
}

template <class Work>
double fastest(const Work& work, int rounds = 25) {
    return 1e9 * lab::fastest(rounds, work);
}

// 1. Nobody reads the result, so the compiler leaves out the work.
// clang-format off
/// [nobody]
double swing(long steps) {
    double x = 1, v = 0;
    for (long i = 0; i < steps; ++i) {
        v -= h * 36 * x;
        x += h * v;
    }
    return x;
}
double watched_by_nobody(long steps) {
    return fastest([&] { swing(steps); }) / double(steps);
}
double read_at_the_end(long steps) {
    return fastest([&] { sink = swing(steps); }) / double(steps);
}
/// [nobody]
// clang-format on

void nobody_looks(lab::Findings& out) {
    const double nobody = watched_by_nobody(20000), read = read_at_the_end(20000);
    out.number("nobody_ns", nobody, "ns", "a step whose result nobody reads", 2);
    out.number("read_ns", read, "ns", "the same step, its result read at the end", 2);
    out.text("nobody_verdict",
             nobody < read / 2 ? "This compiler has left out what nobody reads"
                               : "This compiler has kept what nobody reads; others leave it out",
             "what the compiler has made of the step whose result nobody reads");
    std::printf("  a step whose result nobody reads   %8.3f ns\n", nobody);
    std::printf("  the same, read at the end          %8.3f ns\n", read);
}

// 2. The first round fetches code and memory.
void first_round(lab::Findings& out) {
    const std::size_t bodies = 200000;
    std::vector<State<double>> all;
    const double made = nanoseconds([&] { all.resize(bodies); });
    const auto pass = [&] {
        for (auto& s : all) s = semi_implicit_euler.step(Spring(6.0), s, h);
    };
    const double first = (made + nanoseconds(pass)) / double(bodies), later = fastest(pass, 10) / double(bodies);
    out.number("first_round_ratio", first / later, "", "making the springs and the first round over a later one", 2);
    std::printf("  making springs and the first round take %.1f times as long as a later one\n", first / later);
}

// 3. One body waits for its own last step; a thousand do not wait for each other.
template <class Method>
double one_body(const Method& method) {
    const long steps = 20000;
    return fastest([&] { sink = run(method, Spring(6.0), start, h, steps).x; }) / double(steps);
}
template <class Method>
double many_bodies(const Method& method) {
    std::vector<State<double>> all(1000, start);
    const double all_of_them = fastest([&] {
        for (int n = 0; n < 20; ++n)
            for (auto& s : all) s = method.step(Spring(6.0), s, h);
    });
    sink = all[500].x;
    return all_of_them / (20.0 * double(all.size()));
}

void one_and_many(lab::Findings& out) {
    const double one = one_body(runge_kutta_4) / one_body(semi_implicit_euler);
    const double many = many_bodies(runge_kutta_4) / many_bodies(semi_implicit_euler);
    out.number("rk4_over_semi_one", one, "", "a step of RK4 over one of semi-implicit Euler, one body", 2);
    out.number("rk4_over_semi_many", many, "", "the same, a thousand bodies", 2);
    std::printf("  RK4 over semi-implicit Euler: %.1f for one body, %.1f for each of a thousand\n", one, many);
}

// 4. Equal runs do not take equal times.
void equal_runs(lab::Findings& out) {
    std::vector<double> times;
    for (int i = 0; i < 1000; ++i)
        times.push_back(nanoseconds([&] { sink = run(runge_kutta_4, Spring(6.0), start, h, 1000).x; }));
    std::sort(times.begin(), times.end());
    double mean = 0;
    for (const double t : times) mean += t / double(times.size());
    char words[40];
    std::snprintf(words, sizeof words, "%.2g times as long as", times[500] / times[0]);
    out.text("median_over_fastest", times[500] / times[0] < 1.05 ? "hardly longer than" : words,
             "median of a thousand equal runs over the fastest");
    out.number("mean_over_fastest", mean / times[0], "", "their mean over the fastest");
    out.number("slowest_over_fastest", times.back() / times[0], "", "the slowest over the fastest", 2);
    std::printf("  a thousand equal runs, over the fastest: median %.2f, mean %.2f, slowest %.1f\n",
                times[500] / times[0], mean / times[0], times.back() / times[0]);
}

// 5. What has come to rest costs more: near zero, numbers are subnormal, and many processors take
// them apart by hand.
void at_rest(lab::Findings& out) {
    const auto time_of = [&](const State<double>& from) {
        return fastest([&] { sink = run(explicit_euler, Spring(0.0), from, h, 20000).x; }) / 20000;
    };
    const double tiny = std::numeric_limits<double>::denorm_min() * 1e6;
    const double usual = time_of(State{0, 1.0, 0.25}), subnormal = time_of(State{0, tiny, tiny});
    out.number("subnormal_ratio", subnormal / usual, "", "a step with subnormal numbers over a usual one", 2);
    std::printf("  a step with subnormal numbers takes %.1f times a usual one\n", subnormal / usual);
}

// 6. After whole swings the mass turns round: there x hardly depends on the time, and a swing that
// is late does not show.
/// [final]
template <class Method>
double error_after(const Method& method, double seconds, long steps) {
    const Spring once_a_second(2 * pi);
    const double h = seconds / double(steps);
    const State end = run(method, once_a_second, start, h, steps);
    return std::fabs(end.x - once_a_second.exact(start, seconds).x);
}
/// [final]

void lucky_end(lab::Findings& out) {
    const auto order = [](double seconds) {
        return std::log2(error_after(semi_implicit_euler, seconds, 4800) /
                         error_after(semi_implicit_euler, seconds, 9600));
    };
    out.number("order_at_4", order(4.0), "", "order of semi-implicit Euler seen after four whole periods");
    out.number("order_at_4_1", order(4.1), "", "the same, seen a tenth of a period later");
    out.check("lucky_end", order(4.0) > 1.5 && std::fabs(order(4.1) - 1) < 0.1,
              "an error looked at only where the mass turns round shows an order that is not there");
    std::printf("  semi-implicit Euler's order, seen at 4 s: %.2f; at 4.1 s: %.2f\n", order(4.0), order(4.1));
}

}  // namespace

void fooled(lab::Findings& out) {
    out.section("Six ways to fool oneself");
    nobody_looks(out);
    first_round(out);
    one_and_many(out);
    equal_runs(out);
    at_rest(out);
    lucky_end(out);
}
