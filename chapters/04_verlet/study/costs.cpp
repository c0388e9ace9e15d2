// What the forms of Verlet cost, and what accuracy they give for it.

#include <algorithm>
#include <cstdio>
#include <map>
#include <vector>

#include <timestep/methods.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"
#include "timing.hpp"

using namespace timestep;

namespace {

volatile double sink;  // results go here, so that the compiler has to compute them

// Seconds a step, for each of a thousand bodies.
template <class Method>
double many_bodies(const Method& method, const Spring<double>& spring, double h) {
    const std::size_t bodies = 1000;
    const int steps = 20;
    std::vector<double> x0(bodies, 1.0), x(bodies, 1.0), v(bodies);
    const double seconds = lab::seconds_of([&] {
        for (int n = 0; n < steps; ++n)
            for (std::size_t i = 0; i < bodies; ++i) {
                if constexpr (TwoStepMethod<Method, Spring<double>, State<double>>) {  // two positions, no v
                    const double x2 =
                        method.step(spring, State{0, x0[i], 0.0}, State{0, x[i], 0.0}, h).x;
                    x0[i] = x[i], x[i] = x2;
                } else {
                    const State next = method.step(spring, State{0, x[i], v[i]}, h);
                    x[i] = next.x, v[i] = next.v;
                }
            }
    });
    sink = x[bodies / 2] + v[bodies / 3];
    return seconds / (double(bodies) * steps);
}

template <class Visit>
void for_each_compared(const Visit& visit) {
    visit(semi_implicit_euler);
    for_each_verlet_method(visit);
    visit(runge_kutta_4);
}

// A spring that counts how often it is asked.
struct CountedSpring : Spring<double> {
    mutable long forces = 0;
    using Spring::Spring;
    double acceleration(double x) const { return ++forces, Spring::acceleration(x); }
};

}  // namespace

void costs(const Settings&, lab::Findings& out) {
    out.section("What it costs");
    const Spring spring(1.0);
    std::map<std::string, double> time;
    for (int repetition = 0; repetition < 25;
         ++repetition)  // interleaved, so that all meet the same machine
        for_each_compared([&](const auto& method) {
            const double t = many_bodies(method, spring, 0.01);
            const auto [entry, added] = time.try_emplace(method.name, t);
            if (!added) entry->second = std::min(entry->second, t);
        });

    const State start{0, 1.0, 0.0};
    const double seconds = 20;
    const auto tried = [](int i) { return std::lround(20 * std::pow(2.0, i / 4.0)); };
    out.number("work_seconds", seconds, "s", "for which the spring is stepped");
    out.number("work_fewest_steps", double(tried(0)), "", "the fewest steps tried");
    out.number("work_most_steps", double(tried(48)), "", "the most steps tried");
    const double semi = time.at(semi_implicit_euler.name);
    auto& table = out.table("costs.tsv", {"method", "order", "forces a step", "time of a step",
                                          "evaluations for 0.1 %"});
    std::printf("  %-20s %8s %8s %22s\n", "", "forces", "time", "forces for 0.1 %");
    long fewest = 0, of_euler = 0, of_velocity = 0;
    bool counted_right = true;
    for_each_compared([&](const auto& method) {
        auto& work = out.table("work_" + lab::id(method.name) + ".tsv", {"evaluations", "error"});
        long needed = 0;
        for (int i = 0; i <= 48; ++i) {
            const long steps = tried(i);
            const State end = run(method, spring, start, seconds / steps, steps);
            const double error = distance(end, spring.exact(start, seconds));
            const long evaluations = steps * method.cost.evaluations;
            if (error < 2) work.row({double(evaluations), error});
            if (error < 1e-3 && needed == 0) needed = evaluations;
        }
        const CountedSpring counted(1.0);
        run(method, counted, start, 0.1, 1000);
        counted_right = counted_right && counted.forces == 1000 * method.cost.evaluations;
        const std::string id = lab::id(method.name);
        if (id == "verlet") fewest = needed;
        if (id == "velocity_verlet") of_velocity = needed;
        if (id == "semi_implicit_euler") of_euler = needed;
        char ratio[16];
        std::snprintf(ratio, sizeof ratio, "%.2f", time.at(method.name) / semi);
        const std::string for_it = needed > 0 ? std::to_string(needed) : "more than tried";
        std::printf("  %-20s %8d %8s %22s\n", method.name, method.cost.evaluations, ratio,
                    for_it.c_str());
        table.row({std::string(method.name), double(method.order), double(method.cost.evaluations),
                   std::string(ratio), for_it});
    });
    out.number("time_verlet", time.at(verlet.name) / semi, "",
               "Verlet's time over semi-implicit Euler's", 2);
    out.number("time_velocity", time.at(velocity_verlet.name) / semi, "",
               "velocity Verlet's time over it", 2);
    out.number("time_rk4", time.at(runge_kutta_4.name) / semi, "", "Runge-Kutta 4's time over it", 3);
    out.number("work_euler", double(of_euler), "", "semi-implicit Euler's evaluations for 0.1 %");
    out.number("work_verlet", double(fewest), "", "Verlet's evaluations for 0.1 %");
    out.number("work_ratio", double(of_euler) / double(fewest), "", "one over the other", 2);
    out.check("counted", counted_right, "every method asks for the force as often as it says");
    out.check(
        "verlet_cheaper", fewest > 0 && fewest < of_euler && of_velocity < of_euler,
        "for an error of 0.1 % Verlet asks for the force less often than semi-implicit Euler");
}
