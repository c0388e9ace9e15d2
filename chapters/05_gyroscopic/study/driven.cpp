// Superposition: a motor turns a box, and each torque is treated in its own way.

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <timestep/measured_order.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;

const PrincipalInertia<double> inertia = box(1.0, 1.0, 2.0, 3.0);
constexpr double seconds = 2;

// A torque that changes with time, in world coordinates, N m.
V motor(double t) { return {3 * std::cos(2 * t), 3 * std::sin(3 * t), 1.5}; }

RigidState<double> start() { return {0, Quaternion<double>::Identity(), V(1, 2, 2)}; }

// The rate of (q, ω) with ω in body coordinates: q̇ = ½ q ω, ω̇ = I⁻¹(T − ω × Iω). Written apart from
// everything it is compared with.
struct Rate {
    Eigen::Vector4d q;
    V omega;
};
Rate rate(double t, const Eigen::Vector4d& q, const V& omega) {
    const Quaternion<double> turn(q);
    const V torque = turn.conjugate() * motor(t);
    return {(turn * Quaternion<double>(0, omega.x(), omega.y(), omega.z())).coeffs() / 2,
            inertia.velocity(torque - omega.cross(inertia.momentum(omega)))};
}

// Classical Runge-Kutta with `steps` steps.
RigidState<double> reference(long steps) {
    const double h = seconds / static_cast<double>(steps);
    Eigen::Vector4d q = start().q.coeffs();
    V w = start().q.conjugate() * start().omega;
    for (long n = 0; n < steps; ++n) {
        const double t = h * static_cast<double>(n);
        const Rate a = rate(t, q, w);
        const Rate b = rate(t + h / 2, q + h / 2 * a.q, w + h / 2 * a.omega);
        const Rate c = rate(t + h / 2, q + h / 2 * b.q, w + h / 2 * b.omega);
        const Rate d = rate(t + h, q + h * c.q, w + h * c.omega);
        q = (q + h / 6 * (a.q + 2 * b.q + 2 * c.q + d.q)).normalized();
        w += h / 6 * (a.omega + 2 * b.omega + 2 * c.omega + d.omega);
    }
    const Quaternion<double> end(q);
    return {seconds, end, end * w};
}

// The angle between two orientations, rad.
double angle(const Quaternion<double>& a, const Quaternion<double>& b) { return a.angularDistance(b); }

}  // namespace

void driven_body(const Settings&, lab::Findings& out) {
    out.section("A box with a motor");
    const RigidState<double> exact = reference(20000), coarser = reference(10000);
    const double doubt = (exact.omega - coarser.omega).norm() + angle(exact.q, coarser.q);
    out.number("driven_seconds", seconds, "s", "for which the box is driven");
    std::printf("%-24s %10s %10s %10s\n", "", "h = 1/60 s", "1/1920 s", "order");
    bool order_one = true;
    double of_passive = 0, of_dropped = 0, of_explicit = 0, least = 1e9;
    for (const Solver& solver : solvers()) {
        const std::string &key = solver.key, &name = solver.name;
        auto& table = out.table("driven_" + key + ".tsv", {"h", "orientation", "spin"});
        std::vector<double> steps, errors;
        for (long rate = 60; rate <= 1920; rate *= 2) {
            const double h = 1.0 / static_cast<double>(rate);
            RigidState<double> s = start();
            for (long n = 0; n < std::lround(seconds) * rate; ++n) s = solver.turn(inertia, s, motor(s.t), h);
            const double error = angle(s.q, exact.q);
            table.row({h, error, (s.omega - exact.omega).norm()});
            steps.push_back(h);
            errors.push_back(error);
        }
        const double order = measured_order({steps.end() - 3, steps.end()}, {errors.end() - 3, errors.end()});
        out.number("driven_" + key + "_order", order, "", name + ": order of the driven box's orientation", 2);
        out.number("driven_" + key + "_error", errors.front(), "rad", name + ": error at 60 Hz", 2);
        std::printf("%-24s %10.3f %10.4f %10.2f\n", name.c_str(), errors.front(), errors.back(), order);
        least = std::min(least, errors.front());
        if (key == "passive") of_passive = errors.front();
        if (key == "dropped") of_dropped = errors.front();
        if (key == "explicit") of_explicit = errors.front();
        if (key == "dropped")
            out.check("driven_dropped", errors.back() > 0.9 * errors.front(),
                      "dropped: steps 32 times as short help nothing");
        else
            order_one = order_one && std::fabs(order - 1) < 0.1;
    }
    out.check("driven_at_60", of_passive > of_dropped && of_explicit == least,
              "at 60 Hz, for so short a time, explicit is nearest, and passive is farther off than "
              "dropped");
    double pushed = 0;
    for (double t = 0; t < seconds; t += 0.01) pushed = std::max(pushed, motor(t).norm());
    out.number("driven_torque", pushed, "N m", "the motor's largest torque", 2);
    out.check("driven_reference", doubt < 1e-10, "the driven box's reference is right to 1e-10");
    // error = C h + D h²: D/C of the order of the rates here, below 10 per s, so within 10/480.
    out.check("driven_order", order_one, "superposition: all but the dropped term are of order one");
}
