#include "turn_exactly.hpp"

#include "property_eigen.hpp"

// All digits, says the task.
EXERCISE_WITHIN(turn_exactly, checker::all_digits);

namespace {

constexpr double pi = std::numbers::pi;

// q and -q are the same orientation.
bool same(const Quaterniond& a, const Quaterniond& b, double tolerance) {
    const double apart = (a.coeffs() - b.coeffs()).norm();
    const double other = (a.coeffs() + b.coeffs()).norm();
    return std::min(apart, other) <= tolerance;
}

// Some operations with numbers up to one, and the rounding of the angle.
double roundoff(double angle) { return 1e-14 + 1e-15 * std::fabs(angle); }

// A body that turns by `angle` in a step.
struct Spin {
    Spin(Draw& draw, double speed, double angle)
        : q(draw_rotation(draw)), axis(draw_direction(draw)), omega(speed * axis), angle(angle), h(angle / speed) {}
    Quaterniond answer() const { return learner(q, omega, h); }

    // A point beside the axis goes round it, which is said here without quaternions.
    bool goes_round(Draw& draw) const {
        const Vector3d point = axis.cross(draw_direction(draw)).normalized();
        const Vector3d before = q * point, up = q * axis;
        const Vector3d after = std::cos(angle) * before + std::sin(angle) * up.cross(before);
        return close(answer() * point, after, 0, 4 * roundoff(angle));
    }

    Quaterniond q;
    Vector3d axis, omega;
    double angle, h;
};

// Neither slow nor long, forwards or back.
Spin draw_spin(Draw& draw) {
    const double speed = draw.log(0.1, 100);
    return Spin(draw, speed, draw.sign() * draw.log(0.01, 6));
}

}  // namespace

PROPERTY("in no time the orientation stays as it is") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Spin spin = draw_spin(draw);
        REQUIRE(same(learner(spin.q, spin.omega, 0), spin.q, 1e-14));
    }
}

PROPERTY("the answer has length one, whatever the spin and the step") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double speed = draw.log(1e-3, 1e5);
        const Spin spin(draw, speed, draw.sign() * draw.log(1e-3, 1e3));
        REQUIRE(close(spin.answer().norm(), 1, 1e-14));
    }
}

PROPERTY("a point beside the axis goes round it by the angle |omega| h, the right way") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        REQUIRE(draw_spin(draw).goes_round(draw));
        const double speed = draw.log(10, 1e5);
        REQUIRE(Spin(draw, speed, draw.sign() * draw.log(10, 1000)).goes_round(draw));
    }
}

PROPERTY("a slow spin adds up over a long time, and a tiny angle is a turn, too") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double slow = draw.log(1e-14, 1e-13), speed = draw.log(0.1, 100);
        REQUIRE(Spin(draw, slow, draw.sign() * draw.log(0.1, 6)).goes_round(draw));
        REQUIRE(Spin(draw, speed, draw.sign() * draw.log(1e-10, 1e-4)).goes_round(draw));
    }
}

// Behind the others: what is wrong for every spin is told before what is wrong for none.
PROPERTY("a body that does not spin stays as it is, for however long") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Spin spin = draw_spin(draw);
        REQUIRE(same(learner(spin.q, Vector3d::Zero(), spin.h), spin.q, 1e-14));
        REQUIRE(same(learner(spin.q, Vector3d::Zero(), 0), spin.q, 1e-14));
    }
}

PROPERTY("two steps in a row are one step of both times, and a step back undoes a step") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Spin spin = draw_spin(draw);
        const double h2 = draw.real(-1, 1) * spin.h;
        const Quaterniond both = learner(spin.q, spin.omega, spin.h + h2);
        REQUIRE(same(learner(spin.answer(), spin.omega, h2), both, 4e-14));
        REQUIRE(same(learner(spin.answer(), spin.omega, -spin.h), spin.q, 4e-14));
    }
}

PROPERTY("it is right for any spin, however slow or fast, and any step, however short or long") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double speed = draw.log(1e-30, 1e6), angle = draw.any_of(-10, 10, {0, pi, 2 * pi, -pi});
        const double most = i % 3 == 0 ? draw.log(1, 6e4) : 1;
        Spin spin(draw, speed, angle * most);
        if (i % 4 == 0) spin.omega = draw.sign() * speed * Vector3d::Unit(i % 3);
        REQUIRE(close(spin.answer().norm(), 1, 1e-14));
    }
}

// Not a whole number of turns: who leaves the orientation as it is, is seen.
PROPERTY("a spin of any size turns it by any angle, from a billionth to a hundred thousand turns, forth or back") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double speed = draw.spread(1e-30, 1e12, i, 20), turns = (i % 21 + draw.real(0, 1)) / 21;
        const double angle = i % 2 == 0 ? draw.spread(1e-9, 6e5, i / 2, 21) : 2 * pi * 1e5 * turns;
        REQUIRE(Spin(draw, speed, draw.sign() * angle).goes_round(draw));
    }
}
