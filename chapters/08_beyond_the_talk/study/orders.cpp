// The order of every method, in the spin and in the orientation.

#include <cmath>
#include <cstdio>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/measured_order.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// Errors of ω and of the orientation after two seconds; step(s, h, n) takes n steps of any rule.
struct Measured {
    std::vector<double> h, spin, orientation;
};
Measured measured(const Body& inertia, const Spin& start, int order, const Steps& step) {
    const Spin truth = Exact(inertia, start)(2);
    Measured m;
    const long least = order == 4 ? 16 : 128;
    for (long steps = least; steps <= 8 * least; steps *= 2) {
        const double h = 2.0 / double(steps);
        const Spin s = step(start, h, steps);
        m.h.push_back(h);
        m.spin.push_back((s.omega - truth.omega).norm() / start.omega.norm());
        m.orientation.push_back(apart(s.q, truth.q));
    }
    return m;
}

std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

}  // namespace

void orders(const Settings&, lab::Findings& out) {
    out.section("Orders");
    const Body brick = box(12.0, 1.0, 2.0, 3.0);
    const Spin start = spinning(Vector(1, 2, 2));
    auto& table = out.table("orders.tsv", {"method", "order in ω", "order in the orientation"});
    auto& points = out.table("order_points.tsv", {"method", "h", "spin", "orientation"});
    bool as_declared = true;
    const auto write = [&](const std::string& name, const std::string& id, const Measured& m) {
        const double spin = measured_order(m.h, m.spin);
        const double orientation = measured_order(m.h, m.orientation);
        std::printf("  %-30s order %.2f in omega, %.2f in the orientation\n", name.c_str(), spin, orientation);
        table.row({name, rounded(spin), rounded(orientation)});
        for (std::size_t i = 0; i < m.h.size(); ++i) points.row({id, m.h[i], m.spin[i], m.orientation[i]});
        points.gap();
        return std::pair(spin, orientation);
    };
    for (const Method& method : methods()) {
        const auto [spin, orientation] =
            write(method.name, method.key, measured(brick, start, method.order, method.made(brick)));
        as_declared =
            as_declared && std::fabs(spin - method.order) < 0.2 && std::fabs(orientation - method.order) < 0.2;
    }
    // As an engine has it: the orientation by the new ω instead of the mean.
    const auto by_new = [&](const auto& solver, double back) {
        return measured(brick, start, 2, [&, back](Spin s, double h, long steps) {
            s.omega = solver.step(brick, s.omega, -back * h);
            for (long n = 0; n < steps; ++n) {
                const Vector omega = solver.step(brick, s.omega, h);
                s = {s.t + h, rotated_in_body(s.q, omega, h), omega};
            }
            return s;
        });
    };
    const auto [spin, orientation] =
        write("half-step Jacobian, new omega", "half_step_new", by_new(half_step_jacobian, 0));
    // With ω started half a step back, once, it is the middle's ω by which each step turns:
    // Strang's splitting, but for half a step of ω at the ends.
    const double jacobian_back = write("half-step Jacobian, new omega, started half a step back", "half_step_back",
                                       by_new(half_step_jacobian, 0.5))
                                     .second;
    const double calm_back =
        write("calm half-step, new omega, started half a step back", "calm_back", by_new(CalmHalfStep{}, 0.5)).second;
    out.check("order_back", std::fabs(jacobian_back - 2) < 0.1 && std::fabs(calm_back - 2) < 0.1,
              "with the new ω, started half a step back, the orientation has order two: half-step "
              "Jacobian, calm half-step");
    out.number("order_new", orientation, "", "order of the orientation by the new omega");
    out.check("orders", as_declared, "every method has the order it declares, in ω and in the orientation");
    out.check("order_new", std::fabs(spin - 2) < 0.1 && std::fabs(orientation - 1) < 0.15,
              "with the new ω instead of the mean the orientation has order one");
}
