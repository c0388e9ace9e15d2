#include "flywheel_step.hpp"

#include "property_eigen.hpp"

// Twelve digits count, says the task.
EXERCISE_WITHIN(flywheel_step, checker::all_digits);

namespace {

struct Ship {
    Vector3d inertia, wheel, omega;
    double h;

    Vector3d after() const {
        REQUIRE(is_of_a_body(inertia));
        return learner(inertia, wheel, omega, h);
    }
    Vector3d momentum() const { return inertia.cwiseProduct(omega) + wheel; }
    // sqrt(I) w: half its square is the energy.
    Vector3d y(const Vector3d& w) const { return inertia.cwiseSqrt().cwiseProduct(w); }
};

// h |omega| lies between the two that are given. One ship in five has no wheel. A huge wheel has
// much more momentum than the ship, up to the 1e12 that the exercise allows. There single precision
// overflows, each writing of it in its own way: no huge one turns a ship before that is refused.
Ship draw_ship(Draw& draw, double least, double most, bool huge = false) {
    const double speed = draw.log(1e-3, 1e3);
    Ship ship{draw_moments(draw, draw.real(0, 1) < 0.5 ? 5 : 1000), Vector3d::Zero(), speed * draw_direction(draw),
              std::min(draw.log(least, most) / speed, 1e6)};
    ship.inertia *= draw.log(1, 5000);
    const double own = ship.inertia.cwiseProduct(ship.omega).norm();  // at most 1e9
    const double size = huge ? draw.log(100 * own, 1e12) : draw.log(0.01, 100) * own;
    if (draw.real(0, 1) < 0.8) ship.wheel = size * draw_direction(draw);
    return ship;
}

// A rod up to a thousand times as long as it is thick, lying along any axis; or a body of three moments that are alike.
Vector3d draw_body(Draw& draw, double least, int i) {
    Vector3d inertia = draw_rod(draw, least, i % 2 == 0 ? 1000 : 2);
    std::swap(inertia[0], inertia[i % 3]);
    return inertia;
}

bool is_passive(const Ship& ship, double tolerance) {
    return ship.y(ship.after()).norm() <= ship.y(ship.omega).norm() * (1 + tolerance);
}

}  // namespace

// Few digits here: single precision should not be taken for another mistake.
PROPERTY("a step of zero changes nothing, and a ship at rest stays at rest, wheel or no wheel") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        Ship pause = draw_ship(draw, 0.1, 10, i % 2 == 1);
        pause.h = 0;
        REQUIRE(close(pause.after(), pause.omega, 1e-5));
        Ship still = draw_ship(draw, 0.1, 10, i % 2 == 1);
        still.omega.setZero();
        REQUIRE(still.after().norm() < 1e-9);
    }
}

PROPERTY("a spin about the wheel's own principal axis stays, and any of a ball without a wheel") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        Ship ship = draw_ship(draw, 0.1, 10);
        const Vector3d axis = Vector3d::Unit(i % 3);
        ship.omega = draw.sign() * ship.omega.norm() * axis;
        ship.wheel = draw.sign() * ship.wheel.norm() * axis;
        REQUIRE(close(ship.after(), ship.omega, 1e-5));
        Ship ball = draw_ship(draw, 0.1, 10);
        ball.inertia.setConstant(ball.inertia[0]);
        ball.wheel.setZero();
        REQUIRE(close(ball.after(), ball.omega, 1e-5));
    }
}

PROPERTY("the energy does not grow, for ordinary steps and for steps that are much too long") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        REQUIRE(is_passive(draw_ship(draw, 1e-3, 1), 1e-5));
        REQUIRE(is_passive(draw_ship(draw, 1, 1e3), 1e-5));
    }
}

// k = h L1 times roots of moments, so that the equation is y2 - k x y2 = y1. Roundoff of k x y2 is
// some epsilons of |k||y2|.
PROPERTY("I (w2 - w1) = h L1 x w2, to twelve digits") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double most = i % 2 == 0 ? 3 : 1e9;
        const Ship ship = draw_ship(draw, 1e-4, most, i % 4 >= 2);
        const Vector3d root = ship.inertia.cwiseSqrt();
        const Vector3d k = ship.h / root.prod() * root.cwiseProduct(ship.momentum());
        const Vector3d y1 = ship.y(ship.omega), y2 = ship.y(ship.after());
        REQUIRE(close(Vector3d(y2 - k.cross(y2)), y1, 0, 1e-12 * (1 + k.norm()) * y1.norm()));
    }
}

PROPERTY("it is right wherever the task allows: small and large ships, slow and fast, tiny steps and pauses of days") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 300; ++i) {
        Ship ship = draw_ship(draw, 1, 1);
        const double least = draw.any_of(1e-5, 1e3, {1e-5, 1e3});
        ship.inertia = draw_body(draw, least, i);
        if (i % 8 == 1) ship.inertia.setConstant(least);  // a ball, whose wheel turns its spin
        if (i % 8 == 3)
            ship.inertia = least * Vector3d(1, 1 + draw.log(1e-9, 1e-2), 1 + draw.log(1e-9, 1e-2));  // nearly one
        ship.omega = draw.any_of(0, 1000, {0, 1000}) * draw_direction(draw);
        ship.wheel = i % 4 == 0 ? Vector3d::Zero() : Vector3d(draw.log(1e-9, 1e12) * draw_direction(draw));
        ship.h = draw.any_of(0, 1e6, {0, 1.0 / 60, 60, 1e6});
        all &= is_passive(ship, 1e-12);
    }
    REQUIRE(all);
}

PROPERTY("no spin is too slow for it, no wheel too slow or too fast, and no step too short or too long") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 420; ++i) {
        Ship ship = draw_ship(draw, 1, 1);
        const double least = draw.spread(1e-5, 1e3, i, 17);
        ship.inertia = draw_body(draw, least, i);
        ship.omega = draw.spread(1e-12, 1000, i, 20) * draw_direction(draw);
        ship.wheel = draw.spread(1e-12, 1e12, i, 19) * draw_direction(draw);
        ship.h = draw.spread(1e-12, 1e6, i, 21);
        // Mostly so long a step that the wheel turns the spin by some radians.
        if (i % 4 != 0) ship.h = std::min(least / ship.wheel.norm() * draw.log(1e-3, 1e3), 1e6);
        all &= is_passive(ship, 1e-12);
    }
    REQUIRE(all);
}
