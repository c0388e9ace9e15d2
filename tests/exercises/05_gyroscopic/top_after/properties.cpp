#include "top_after.hpp"

#include "property_eigen.hpp"

// Exact but for rounding, says the task.
EXERCISE_WITHIN(top_after, checker::all_digits);

namespace {

using Eigen::Vector3d;

// A symmetric body, from a staff to a flat plate (along is twice across), and how it spins.
struct Top {
    explicit Top(Draw& draw)
        : across(draw.log(0.01, 100)),
          along(across * draw.real(0.05, 2)),
          omega(draw.log(0.5, 10) * draw_direction(draw)) {}
    // Spins about its axis and across it, so that something turns.
    static Top tilted(Draw& draw) {
        Top top(draw);
        const double angle = draw.real(0, 2 * std::numbers::pi), up = draw.sign() * draw.real(0.2, 0.9);
        const Vector3d across(std::cos(angle), std::sin(angle), 0);
        top.omega = draw.log(0.5, 10) * (std::sqrt(1 - up * up) * across + up * Vector3d::UnitZ());
        return top;
    }
    Top(double across_, double along_, const Vector3d& omega_) : across(across_), along(along_), omega(omega_) {}
    Vector3d after(double t) const { return learner(across, along, omega, t); }
    // Of a length, where each component is a cosine of its own angle: its rounding shows.
    double roundoff(double t) const { return 1e-13 + 1e-15 * std::fabs((along - across) / across * omega.z() * t); }

    double across, along;
    Vector3d omega;
};

// What Euler's equations make of the spin, without a torque.
Vector3d acceleration(const Top& top, const Vector3d& omega) {
    const Vector3d inertia(top.across, top.across, top.along);
    const Vector3d torque = -omega.cross(inertia.cwiseProduct(omega));
    return torque.cwiseQuotient(inertia);
}

// The part across the axis of symmetry.
Vector3d across_part(const Vector3d& omega) { return {omega.x(), omega.y(), 0}; }

}  // namespace

PROPERTY("after no time the spin is what it was") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Top top(draw);
        REQUIRE(close(top.after(0), top.omega, 1e-14));
    }
}

PROPERTY("a sphere keeps its spin, as does any top that spins only along its axis or across it") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Top top(draw);
        const double t = draw.real(-5, 5);
        for (const Vector3d& kept :
             {Vector3d(0, 0, top.omega.z()), across_part(top.omega), Vector3d(top.omega.x(), 0, 0), Vector3d(0, 0, 0)})
            REQUIRE(close(learner(top.across, top.along, kept, t), kept, 1e-13));
        REQUIRE(close(learner(top.across, top.across, top.omega, t), top.omega, 1e-13));
    }
}

PROPERTY("the energy, the size of the angular momentum and the spin along the axis stay") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Top top(draw);
        const Vector3d inertia(top.across, top.across, top.along);
        const Vector3d later = top.after(draw.real(-5, 5));
        REQUIRE(close(later.z(), top.omega.z(), 0, 1e-13 * top.omega.norm()));
        REQUIRE(close(later.dot(inertia.cwiseProduct(later)), top.omega.dot(inertia.cwiseProduct(top.omega)), 1e-13));
        REQUIRE(close(inertia.cwiseProduct(later).norm(), inertia.cwiseProduct(top.omega).norm(), 1e-13));
    }
}

// An eighth of a second, at 10 rad/s at most: it goes round by less than half a turn.
PROPERTY("the part across goes round the way a flat body spins, and a long one's the other way") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        Top top = Top::tilted(draw);
        const double t = draw.sign() * draw.real(0.05, 0.125);
        const bool flat = i % 2 == 0;
        top.along = top.across * (flat ? draw.real(1.1, 2) : draw.real(0.05, 0.9));
        const double turned = across_part(top.omega).cross(across_part(top.after(t))).z();
        REQUIRE(turned * t * top.omega.z() * (flat ? 1 : -1) > 0);
    }
}

// A central difference is off by a share (rate dt)²/6, below 2e-7. The rounding of angles up to 50,
// divided by dt, comes to about 1e-10 of the spin.
PROPERTY("the spin changes as Euler's equations say, at any time") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Top top(draw);
        const double t = draw.real(-5, 5), dt = 1e-4;
        const Vector3d change = (top.after(t + dt) - top.after(t - dt)) / (2 * dt);
        const Vector3d euler = acceleration(top, top.after(t));
        REQUIRE(close(change, euler, 1e-6, 1e-9 * top.omega.norm()));
    }
}

PROPERTY("it is right for any top, tiny or huge, nearly round or a needle, any spin and any time") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double across = draw.log(1e-12, 1e12), nearly = 1 + draw.sign() * draw.log(1e-11, 1e-2);
        const double along = across * (i % 3 == 0 ? nearly : draw.any_of(1e-6, 2, {1, 2}));
        const double speed = draw.log(1e-6, 1e6), t = draw.any_of(-1e3, 1e3, {0}) / speed;
        const double x = draw.any_of(-1, 1, {0}), y = draw.any_of(-1, 1, {0});
        const double wobble = i % 2 == 0 ? 1 : draw.log(1e-12, 1);
        const Vector3d omega(wobble * x, wobble * y, draw.any_of(-1, 1, {0, 1}));
        const Top top(across, along, speed * omega);
        REQUIRE(close(top.after(t).norm(), top.omega.norm(), top.roundoff(t)));
    }
}

PROPERTY("no moment, no spin and no time is too small or too large for it, forth or back") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double across = draw.spread(1e-12, 1e12, i, 17), along = across * draw.spread(1e-12, 2, i, 19);
        const double speed = draw.spread(1e-12, 1e12, i, 20), t = draw.sign() * draw.spread(1e-9, 1e6, i, 21) / speed;
        const Top top(across, along, speed * draw_direction(draw));
        REQUIRE(close(top.after(t).norm(), top.omega.norm(), top.roundoff(t)));
    }
}
