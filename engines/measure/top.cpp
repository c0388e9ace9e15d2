// A top: gravity makes it precess. It stands on a point that holds it, or on the ground.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "scenes.hpp"

namespace engines {

namespace {

constexpr double arm = 0.4;     // m from the point to the middle
constexpr double lean = 0.4;    // rad off upright
constexpr double fallen = 1.3;  // rad off upright: it lies, or as good as
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

double off_upright(const Vector& axis) { return std::acos(std::clamp(axis.z(), -1.0, 1.0)); }

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

void hold_tops(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    const int steps = effort.quick ? 600 : 1200;
    for (const double spin : {20.0, 30.0}) {
        const Truth truth = true_motion(spin, steps);
        std::printf(
            "\na top, %g rad/s, %g s; it truly precesses by %.2f rad, leans by %.2f at most and keeps %.3f of its "
            "spin\n%-48s %8s %8s %8s %8s\n",
            spin, steps * step, truth.angle, truth.lean, truth.spin, "", "rad", "off, %", "spin", "lean");
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

// A top on its round foot, on ground without friction. Where the momentum L about its axis and the precession Ω fit,
// I Ω² cos(lean) − L Ω + m g arm = 0, it truly leans by the same angle for ever, and its middle stays where it is. With
// friction the foot slips, rolls and makes the top rise, in each engine by a law of its own.
constexpr double foot = 0.05;  // m, its radius
const Shape round_top{Shape::capsule, {foot, foot, arm}, {0.070, 0.070, 0.125}, 1};

double slow_precession(double spin) {
    const double L = round_top.moments.z() * spin, I = round_top.moments.x(), weight = round_top.mass * g * arm;
    return 2 * weight / (L + std::sqrt(L * L - 4 * I * weight * std::cos(lean)));
}

struct Stood {
    double stands = 0;          // s until it falls, or as long as it was watched
    double angle = 0;           // rad: of the precession until then
    double lean_off = 0;        // rad: the lean is off by until then, at most
    double most = 1, left = 1;  // energy, over the first: the most ever, and at the end
};
Stood stood(const Engine& engine, double spin, int steps) {
    const auto world = engine.world({.gravity = g, .smooth = true});
    world->ground();
    const double rate = slow_precession(spin);
    State s = leaning(spin);
    s.omega += rate * (Vector::UnitZ() - std::cos(lean) * (s.q * Vector::UnitZ()));
    s.x = Vector(0, 0, foot + arm * std::cos(lean));
    world->add(round_top, s);
    const auto energy = [&] {
        return round_top.mass * (s.v.squaredNorm() / 2 + g * s.x.z()) + spin_energy(round_top, s);
    };
    const double first = energy();
    Precession precession;
    Stood top;
    bool fell = false;
    for (int n = 0; n < steps; ++n) {
        world->step(step);
        s = world->state(0);
        top.left = energy() / first, top.most = std::max(top.most, top.left);
        const Vector axis = s.q * Vector::UnitZ();
        fell = fell || off_upright(axis) > fallen;
        if (fell) continue;
        precession.see(axis);
        top.stands = (n + 1) * step;
        top.lean_off = std::max(top.lean_off, std::fabs(off_upright(axis) - lean));
    }
    top.angle = precession.angle + std::numbers::pi / 2;
    return top;
}

void stand_tops(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    const int steps = effort.quick ? 600 : 1200;
    for (const double spin : {20.0, 30.0}) {
        const double rate = slow_precession(spin);
        std::printf(
            "\na top on smooth ground, %g rad/s, %g s; it truly precesses by %.2f rad and leans by %g for ever\n%-48s "
            "%8s %8s %8s %8s %8s %8s\n",
            spin, steps * step, rate * steps * step, lean, "", "stands,s", "rad", "off, %", "lean off",
            "energy<=", "energy");
        for (const Engine& engine : engines) {
            const Stood top = stood(engine, spin, steps);
            const double off = 100 * std::fabs(top.angle / (rate * top.stands) - 1);
            std::printf("%s %8.2f %8.2f %8.1f %8.3f %8.3f %8.3f\n", row_name(engine).c_str(), top.stands, top.angle,
                        off, top.lean_off, top.most, top.left);
            char which[32];
            std::snprintf(which, sizeof which, "%g rad/s", spin);
            numbers.add("top on the ground", which, engine, "stands, s", top.stands);
            numbers.add("top on the ground", which, engine, "off, %", off);
            if (top.stands > (steps - 0.5) * step)
                numbers.add("top on the ground", which, engine, "lean off, rad", top.lean_off);
            numbers.add("top on the ground", which, engine, "most energy", top.most);
            numbers.add("top on the ground", which, engine, "energy left", top.left);
        }
    }
}

}  // namespace

void spin_tops(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    hold_tops(engines, effort, numbers);
    stand_tops(engines, effort, numbers);
}

}  // namespace engines
