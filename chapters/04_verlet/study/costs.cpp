// What the forms of Verlet cost, and what accuracy they give for it.

#include <algorithm>
#include <cstdio>

#include <timestep/methods.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

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
    const State start{0, 1.0, 0.0};
    const double seconds = 20;
    const auto tried = [](int i) { return std::lround(20 * std::pow(2.0, i / 4.0)); };
    out.number("work_seconds", seconds, "s", "for which the spring is stepped");
    out.number("work_fewest_steps", double(tried(0)), "", "the fewest steps tried");
    out.number("work_most_steps", double(tried(48)), "", "the most steps tried");
    auto& table = out.table("costs.tsv", {"method", "order", "forces a step", "evaluations for 0.1 %"});
    std::printf("  %-20s %8s %22s\n", "", "forces", "forces for 0.1 %");
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
        const std::string for_it = needed > 0 ? std::to_string(needed) : "more than tried";
        std::printf("  %-20s %8d %22s\n", method.name, method.cost.evaluations, for_it.c_str());
        table.row({std::string(method.name), double(method.order), double(method.cost.evaluations), for_it});
    });
    out.number("work_euler", double(of_euler), "", "semi-implicit Euler's evaluations for 0.1 %");
    out.number("work_verlet", double(fewest), "", "Verlet's evaluations for 0.1 %");
    out.check("counted", counted_right, "every method asks for the force as often as it says");
    out.check("verlet_cheaper", fewest > 0 && fewest < of_euler && of_velocity < of_euler,
              "for an error of 0.1 % Verlet asks for the force less often than semi-implicit Euler");
}
