// What a step costs, and what accuracy costs: measured here, on this machine, side by side.

#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"
#include "timing.hpp"

using namespace timestep;

namespace {

volatile double sink;  // results go here, so that the compiler has to compute them

// One body, step after step: each step waits for the one before.
template <class Method, class Model>
double one_body(const Method& method, const Model& model, double h) {
    const long steps = 20000;
    return lab::seconds_of([&] { sink = run(method, model, State{0, 1.0, 0.0}, h, steps).x; }) / steps;
}

// A thousand bodies: their steps do not wait for each other.
template <class Method, class Model>
double many_bodies(const Method& method, const Model& model, double h) {
    const std::size_t bodies = 1000;
    const int steps = 20;
    std::vector<double> x0(bodies, 1.0), v0(bodies), x(bodies, 1.0), v(bodies);
    return lab::seconds_of([&] {
               for (int n = 0; n < steps; ++n)
                   for (std::size_t i = 0; i < bodies; ++i) {
                       const State now{0, x[i], v[i]};
                       State<double> next;
                       if constexpr (TwoStepMethod<Method, Model, State<double>>) {
                           next = method.step(model, State{0, x0[i], v0[i]}, now, h);
                           x0[i] = x[i], v0[i] = v[i];
                       } else {
                           next = method.step(model, now, h);
                       }
                       x[i] = next.x, v[i] = next.v;
                   }
               sink = x[bodies / 2] + v[bodies / 3];
           }) /
           (double(bodies) * steps);
}

// A pendulum that counts how often it is asked.
struct CountedPendulum : Pendulum<double> {
    mutable long forces = 0, slopes = 0;
    using Pendulum::Pendulum;
    double acceleration(double x) const { return ++forces, Pendulum::acceleration(x); }
    double slope_x(double x) const { return ++slopes, Pendulum::slope_x(x); }
};

// Of many random starts, the percentage for which Newton-Raphson ends on no root of the implicit
// step.
double newton_fails(double wh) {
    const Pendulum pendulum(1.0);
    std::mt19937 random(1);
    const auto between = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    int failed = 0;
    const int starts = 20000;
    for (int i = 0; i < starts; ++i) {
        const State start{0, between(-pi, pi), between(-3, 3)};
        const State end = implicit_euler.step(pendulum, start, wh);
        const double missing = end.v - start.v - wh * pendulum.acceleration(end.x);
        if (!(std::fabs(missing) < 1e-9 * (1 + wh))) ++failed;
    }
    return 100.0 * failed / starts;
}

struct Times {
    double one = 1, many = 1, pendulum = 1;  // seconds a step, the least of the repetitions
};

std::map<std::string, Times> measure() {
    std::map<std::string, Times> times;
    const Spring spring(1.0);
    const Pendulum pendulum(1.0);
    const double h = 0.01;
    for (int repetition = 0; repetition < 25; ++repetition)  // interleaved, so that all meet the same machine
        for_each_method([&](const auto& method) {
            Times& t = times[method.name];
            t.one = std::min(t.one, one_body(method, spring, h));
            t.many = std::min(t.many, many_bodies(method, spring, h));
            t.pendulum = std::min(t.pendulum, one_body(method, pendulum, h));
        });
    return times;
}

void cost_table(const std::map<std::string, Times>& times, lab::Findings& out) {
    std::printf("  %-20s %6s %6s %8s %8s %10s %6s %6s\n", "", "spring", "", "ns a", "ns of", "ns a", "", "");
    std::printf("  %-20s %6s %6s %8s %8s %10s %6s %6s\n", "", "forces", "solves", "step", "many", "pendulum", "forces",
                "solves");
    auto& table = out.table("costs.tsv",
                            {"method", "forces", "solves", "ns a step, one spring", "ns a step, each of 1000 springs",
                             "ns a step, one pendulum", "forces, pendulum", "solves, pendulum"});
    const auto rounded = [](double value) {
        char text[24];
        std::snprintf(text, sizeof text, "%.2f", value);
        return std::string(text);
    };
    for_each_method([&](const auto& method) {
        const CountedPendulum counted(1.0);
        const long steps = 1000;
        run(method, counted, State{0, 1.0, 0.0}, 0.1, steps);
        if (std::string(method.name) == "implicit Euler")
            out.number("newton_rounds", double(counted.slopes) / steps, "", "Newton-Raphson iterations a step", 2);
        const Times& t = times.at(method.name);
        const double forces = double(counted.forces) / steps, solves = double(counted.slopes) / steps;
        std::printf("  %-20s %6d %6d %8.2f %8.2f %10.2f %6.2f %6.2f\n", method.name, method.cost.evaluations,
                    method.cost.solves, 1e9 * t.one, 1e9 * t.many, 1e9 * t.pendulum, forces, solves);
        table.row({std::string(method.name), double(method.cost.evaluations), double(method.cost.solves),
                   rounded(1e9 * t.one), rounded(1e9 * t.many), rounded(1e9 * t.pendulum), rounded(forces),
                   rounded(solves)});
    });
    const double gentle = newton_fails(1), rough = newton_fails(1.5);
    std::printf(
        "  Newton-Raphson misses the pendulum's root for %g %% of 20000 starts at\n"
        "  omega h = 1, and for %g %% at 1.5\n",
        gentle, rough);
    out.number("newton_fails_gentle", gentle, "%", "Newton-Raphson without a root at omega h = 1", 2);
    out.number("newton_fails_rough", rough, "%", "Newton-Raphson without a root at omega h = 1.5", 2);
    // What is missing has the slope 1 + (ωh)² cos x₂ by v₂: up to ωh = 1 it only rises, and
    // Newton-Raphson with halved steps solves it from anywhere. Beyond, it may stop where the slope
    // vanishes.
    out.check("newton_may_fail", gentle == 0 && rough > 0,
              "Newton-Raphson finds every root at omega h = 1 and misses some at 1.5");
    const Times &e = times.at("explicit Euler"), &s = times.at("semi-implicit Euler"), &i = times.at("implicit Euler");
    out.number("alone_ratio", s.one / e.one, "", "semi-implicit over explicit, one spring", 2);
    out.number("many_ratio", s.many / e.many, "", "semi-implicit over explicit, each of 1000 springs", 2);
    out.number("implicit_ratio", i.many / s.many, "", "implicit over semi-implicit, each of 1000 springs", 2);
    out.number("implicit_ratio_pendulum", i.pendulum / s.pendulum, "", "implicit over semi-implicit, pendulum", 2);
}

// Error at the end of three swings against the time that its steps take.
void work_and_precision(const std::map<std::string, Times>& times, lab::Findings& out) {
    const Spring spring(1.0);
    const State start{0, 1.0, 0.0};
    const double seconds = 20;
    const std::pair<double, const char*> wanted[] = {
        {0.1, "10 %"}, {0.01, "1 %"}, {0.001, "0.1 %"}, {1e-6, "0.0001 %"}};
    struct Best {
        double time = 1e9;
        std::string method = "none";
        long steps = 0;
    } best[4];
    std::map<std::string, long> asked;  // the fewest evaluations for an error of 0.1 %
    for_each_method([&](const auto& method) {
        auto& table = out.table("work_" + lab::id(method.name) + ".tsv", {"microseconds", "error", "evaluations"});
        for (int i = 0; i <= 44; ++i) {
            const long steps = std::lround(10 * std::pow(2.0, i / 3.0));
            const State end = run(method, spring, start, seconds / steps, steps);
            const State exact = spring.exact(start, seconds);
            const double error = std::hypot(end.x - exact.x, end.v - exact.v);
            const double time = times.at(method.name).one * steps;
            const long evaluations = steps * method.cost.evaluations;
            if (error < 2) table.row({1e6 * time, error, double(evaluations)});
            if (error <= 1e-3) asked.try_emplace(lab::id(method.name), evaluations);
            for (int k = 0; k < 4; ++k)
                if (error <= wanted[k].first && time < best[k].time) best[k] = {time, method.name, steps};
        }
    });
    out.section("The cheapest method for an accuracy");
    auto& table = out.table("ranking.tsv", {"wanted error", "cheapest here", "steps a period", "µs for 20 s"});
    for (int k = 0; k < 4; ++k) {
        char swing[16], time[16];
        std::snprintf(swing, sizeof swing, "%.1f", best[k].steps * 2 * pi / seconds);
        std::snprintf(time, sizeof time, "%.2f", 1e6 * best[k].time);
        std::printf("  %-9s %-20s %6s steps a period, %6s us for 20 s\n", wanted[k].second, best[k].method.c_str(),
                    swing, time);
        table.row({std::string(wanted[k].second), best[k].method, std::string(swing), std::string(time)});
    }
    // Order one needs a hundred times the steps for an error a hundred times smaller; no machine
    // makes up for it. Counted, for a clock tells of the machine, too. A method that is not in
    // `asked` never gets there.
    const auto evaluations = [&](const char* name) {
        const auto found = asked.find(name);
        return found == asked.end() ? std::numeric_limits<long>::max() : found->second;
    };
    const long euler =
        std::min({evaluations("explicit_euler"), evaluations("semi_implicit_euler"), evaluations("implicit_euler")});
    long higher = 0;  // the most that one of these asks for
    for (const char* name : {"midpoint", "heun", "runge_kutta_4"}) higher = std::max(higher, evaluations(name));
    std::printf("  forces asked for an error of 0.1 %%: the least Euler %ld, RK4 %ld\n", euler,
                evaluations("runge_kutta_4"));
    out.number("euler_asks", double(euler), "", "forces that the cheapest Euler asks for, for 0.1 %");
    out.number("rk4_asks", double(evaluations("runge_kutta_4")), "", "and Runge-Kutta 4");
    out.check("smooth_prefers_order", higher < euler,
              "for an error of 0.1 % on a smooth spring midpoint, Heun and Runge-Kutta 4 ask for "
              "the force less "
              "often than any Euler");
}

}  // namespace

void costs(const Settings&, lab::Findings& out) {
    out.section("What a step costs");
    const auto times = measure();
    cost_table(times, out);
    work_and_precision(times, out);
}
