// A top on a point that holds it: gravity makes it precess.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "scenes.hpp"

namespace engines {

namespace {

constexpr double arm = 0.4;     // m from the point to the middle
constexpr double lean = 0.4;    // rad off upright
const Shape disc{Shape::box, {0.5, 0.5, 0.05}, {0.070, 0.072, 0.125}, 1};

// The angle of the axis about the vertical, counted on over whole turns.
class Precession {
public:
    void see(const Vector& axis) {
        const double now = std::atan2(axis.y(), axis.x());
        angle += std::remainder(now - before_, 2 * std::numbers::pi);
        before_ = now;
    }
    double angle = -std::numbers::pi / 2;

private:
    double before_ = -std::numbers::pi / 2;  // where it leans at the start
};

double off_upright(const Vector& axis) {
    return std::acos(std::clamp(axis.z(), -1.0, 1.0));
}

State leaning(double spin) {
    State s;
    s.q = Quaternion(Eigen::AngleAxisd(lean, Vector::UnitX()));
    const Vector axis = s.q * Vector::UnitZ();
    s.x = arm * axis, s.omega = spin * axis;
    return s;
}

// The truth: Euler's equations about the point with gravity's torque, by Runge-Kutta 4 in a hundredth of a frame.
struct Truth {
    double angle, lean;  // rad: of the precession, and the largest off upright
    double spin;         // about its axis, at the end, over that at the start
};
Truth true_motion(double spin, int steps) {
    const Vector I = disc.moments + disc.mass * arm * arm * Vector(1, 1, 0);
    struct Rate {
        Eigen::Vector4d q;
        Vector omega;
    };
    const auto rate = [&](const Quaternion& q, const Vector& w) -> Rate {
        const Vector weight = q.conjugate() * Vector(0, 0, -disc.mass * g);
        const Vector torque = (arm * Vector::UnitZ()).cross(weight) - w.cross(I.cwiseProduct(w));
        return {(q * Quaternion(0, w.x() / 2, w.y() / 2, w.z() / 2)).coeffs(), torque.cwiseQuotient(I)};
    };
    const State start = leaning(spin);
    Quaternion q = start.q;
    Vector w = in_body(start);
    Precession precession;
    double most = 0;
    const int parts = 100;
    const double h = step / parts;
    for (int n = 0; n < steps * parts; ++n) {
        const auto moved = [&](const Rate& r, double by) { return Quaternion(Eigen::Vector4d(q.coeffs() + by * r.q)); };
        const Rate k1 = rate(q, w), k2 = rate(moved(k1, h / 2), w + h / 2 * k1.omega),
                   k3 = rate(moved(k2, h / 2), w + h / 2 * k2.omega), k4 = rate(moved(k3, h), w + h * k3.omega);
        q.coeffs() += h / 6 * (k1.q + 2 * k2.q + 2 * k3.q + k4.q);
        w += h / 6 * (k1.omega + 2 * k2.omega + 2 * k3.omega + k4.omega);
        q.normalize();
        const Vector axis = q * Vector::UnitZ();
        if ((n + 1) % parts == 0) precession.see(axis), most = std::max(most, off_upright(axis));
    }
    return {precession.angle + std::numbers::pi / 2, most, w.z() / spin};
}

}  // namespace

void spin_tops(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    const int steps = effort.quick ? 600 : 1200;
    for (const double spin : {20.0, 30.0}) {
        const Truth truth = true_motion(spin, steps);
        std::printf("\na top, %g rad/s, %g s; it truly precesses by %.2f rad, leans by %.2f at most and keeps %.3f of its spin\n%-48s %8s %8s %8s %8s\n", spin, steps * step,
                    truth.angle, truth.lean, truth.spin, "", "rad", "off, %", "spin", "lean");
        for (const Engine& engine : engines) {
            const auto world = engine.world({g, false, false});
            world->add(disc, leaning(spin));
            world->pin(0, Vector(0, 0, -arm), -1, Vector::Zero());
            Precession precession;
            double most = 0;
            for (int n = 0; n < steps; ++n) {
                world->step(step);
                const Vector axis = world->state(0).q * Vector::UnitZ();
                precession.see(axis);
                most = std::max(most, off_upright(axis));
            }
            const double angle = precession.angle + std::numbers::pi / 2, left = in_body(world->state(0)).z() / spin;
            const double off = 100 * std::fabs(angle / truth.angle - 1);
            std::printf("%s %8.2f %8.1f %8.3f %8.2f\n", row_name(engine).c_str(), angle, off, left, most);
            char which[32];
            std::snprintf(which, sizeof which, "%g rad/s", spin);
            numbers.add("top", which, engine, "precession, rad", angle);
            numbers.add("top", which, engine, "true precession, rad", truth.angle);
            numbers.add("top", which, engine, "off, %", off);
            numbers.add("top", which, engine, "spin left", left);
            numbers.add("top", which, engine, "largest lean, rad", most);
            numbers.add("top", which, engine, "true largest lean, rad", truth.lean);
        }
    }
}

}  // namespace engines
