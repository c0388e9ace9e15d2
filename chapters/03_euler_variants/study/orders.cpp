// How fast the error falls with the step, for every method.

#include <algorithm>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

const State<double> start{0, 1.0, 0.0};

double distance(const State<double>& a, const State<double>& b, double omega) {
    return amplitude({0, a.x - b.x, a.v - b.v}, omega);
}

// The error at the end of the run.
template <class Method>
double global_error(const Method& method, const Spring<double>& spring, double seconds, long steps) {
    const State end = run(method, spring, start, seconds / steps, steps);
    return distance(end, spring.exact(start, seconds), spring.omega);
}

// The error of one step from an exact state; a two-step method gets an exact state before it, too.
template <class Method>
double local_error(const Method& method, const Spring<double>& spring, double h) {
    const State exact = spring.exact(start, h);
    if constexpr (TwoStepMethod<Method, Spring<double>, State<double>>)
        return distance(method.step(spring, spring.exact(start, -h), start, h), exact, spring.omega);
    else
        return distance(method.step(spring, start, h), exact, spring.omega);
}

// The largest ωh at which the undamped spring does not grow; two-step methods are simulated, from
// 0.01 to 1e6, since their step is no 2×2 matrix.
template <class Method>
double longest_step(const Method& method) {
    const Spring spring(1.0);
    const auto stable = [&](double wh) {
        if constexpr (requires { step_matrix(method, spring, wh); })
            return spectral_radius(step_matrix(method, spring, wh)) <= 1 + 8 * 2.2e-16;
        else
            return amplitude(run(method, spring, start, wh, 2000), 1) <= 1;
    };
    if constexpr (TwoStepMethod<Method, Spring<double>, State<double>>) {
        for (double wh = 0.01; wh < 1e6; wh *= 1.2)
            if (!stable(wh)) return wh;
        return 1e6;
    } else {
        return largest_stable_step(stable, 1e6);
    }
}

}  // namespace

void orders(const Settings& settings, lab::Findings& out) {
    out.section("Order: how the error falls with the step");
    const Spring spring(settings.omega);
    const double radians = 2, seconds = radians / settings.omega;
    std::printf("  %-20s %14s %14s\n", "", "a step", "the whole run");

    auto& summary = out.table("methods.tsv", {"method", "largest stable ωh", "declared order", "measured order",
                                              "order of one step", "evaluations", "solves"});
    bool all_right = true;          // every method, its order in a run and in a step
    bool solving_is_stable = true;  // every method that solves, at every step that was tried
    for_each_method([&](const auto& method) {
        const std::string id = lab::id(method.name);
        auto& table = out.table("orders_" + id + ".tsv", {"steps_per_period", "step", "local", "global"});
        std::vector<double> h, local, global;
        for (int i = 0; i <= 12; ++i) {
            const long steps = std::lround(20 * std::pow(2.0, i / 2.0));
            const double step = seconds / steps;
            const double l = local_error(method, spring, step);
            const double g = global_error(method, spring, seconds, steps);
            table.row({steps * 2 * pi / radians, step, l, g});
            // The fit leaves out the long steps, where higher terms of the Taylor series count.
            if (i >= 4) h.push_back(step), local.push_back(l), global.push_back(g);
        }
        const double one = measured_order(h, local), whole = measured_order(h, global);
        std::printf("  %-20s %14.2f %14.2f\n", method.name, one, whole);
        all_right = all_right && std::fabs(whole - method.order) < 0.1 && std::fabs(one - method.order - 1) < 0.1;
        out.check("order_" + id, std::fabs(whole - method.order) < 0.1 && std::fabs(one - method.order - 1) < 0.1,
                  std::string(method.name) + " has the order it declares, and one more for a single step");

        const double longest = longest_step(method);
        if (method.order == 4) {
            out.number("rk4_limit", longest, "", "largest stable omega h of RK4");
            out.number("rk4_limit_per_evaluation", longest / method.cost.evaluations, "",
                       "largest stable omega h of RK4 over its evaluations", 2);
        }
        char text[24];
        std::snprintf(text, sizeof text, "%.3g", longest);
        const std::string limit = longest > 1e5 ? "no limit" : longest < 0.01 ? "0, always grows" : text;
        char whole_text[16], one_text[16];
        std::snprintf(whole_text, sizeof whole_text, "%.2f", whole);
        std::snprintf(one_text, sizeof one_text, "%.2f", one);
        if (method.cost.solves > 0 && !(longest > 1e5)) solving_is_stable = false;
        summary.row({std::string(method.name), limit, double(method.order), std::string(whole_text),
                     std::string(one_text), double(method.cost.evaluations), double(method.cost.solves)});
    });
    out.check("all_orders", all_right,
              "each of the eight methods has the order it declares, and one more for a single step");
    out.check("implicit_no_limit", solving_is_stable,
              "implicit Euler, implicit midpoint and BDF2 do not grow on a spring, at any omega h "
              "up to 1e5");
}
