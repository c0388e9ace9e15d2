#include "world_acceleration.hpp"

#include "property_eigen.hpp"

// All in the world, with the tensor of this orientation: right, and where the torques cancel, or none is to be, it has
// the roundoff of what is added up.
static Vector3d by_tensor(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    const Matrix3d R = q.toRotationMatrix(), I = R * inertia.asDiagonal() * R.transpose();
    return I.inverse() * (torque - omega.cross(I * omega));
}

EXERCISE_BESIDE(world_acceleration, 2e-12, by_tensor);

namespace {

struct Body {
    explicit Body(Draw& draw)
        : inertia(draw_moments(draw, 10)),
          q(draw_rotation(draw)),
          omega(draw.log(0.5, 10) * draw_direction(draw)),
          torque(draw.log(0.5, 100) * inertia.minCoeff() * draw_direction(draw)) {}

    // One of the body's own axes, in the world.
    Vector3d axis(int i) const { return q * Vector3d::Unit(i); }
    // The inertia tensor times a vector, both in the world: each axis adds its part.
    Vector3d times_tensor(const Vector3d& v) const {
        Vector3d sum = Vector3d::Zero();
        for (int i = 0; i < 3; ++i) sum += inertia[i] * v.dot(axis(i)) * axis(i);
        return sum;
    }
    Vector3d acceleration() const {
        REQUIRE(is_of_a_body(inertia));
        return learner(inertia, q, omega, torque);
    }
    // Two equal moments: the third is at most twice as large.
    void make_round(int one, int other) {
        inertia[one] = std::max(inertia[one], inertia[3 - one - other] / 2);
        inertia[other] = inertia[one];
    }
    // The size of the torques that are added up: roundoff is 1e-16 of that, times some ten.
    double size() const { return torque.norm() + inertia.maxCoeff() * omega.squaredNorm(); }

    Vector3d inertia;
    Quaterniond q;
    Vector3d omega, torque;
};

}  // namespace

PROPERTY("at rest, a torque about one of the body's own axes is divided by the moment about it") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        Body body(draw);
        const double size = body.torque.norm();
        body.torque = size * body.axis(i % 3);
        body.omega = Vector3d::Zero();
        const Vector3d expected = size / body.inertia[i % 3] * body.axis(i % 3);
        REQUIRE(close(body.acceleration(), expected, 1e-13));
    }
}

PROPERTY("a ball has no gyroscopic torque: however it spins, only the torque from outside counts") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        Body ball(draw);
        const double moment = ball.inertia.x();
        ball.inertia = Vector3d::Constant(moment);
        const double roundoff = 1e-13 * ball.size() / moment;
        REQUIRE(close(ball.acceleration(), ball.torque / moment, 0, roundoff));
    }
}

// The energy is half of ω·Iω, and gains L·a.
PROPERTY("the energy gains just the power of the torque, and a free body keeps its energy") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        Body body(draw);
        if (i % 4 == 0) body.torque = Vector3d::Zero();
        const Vector3d L = body.times_tensor(body.omega);
        const double power = body.torque.dot(body.omega);
        const double roundoff = 1e-12 * body.size() * body.omega.norm();
        REQUIRE(close(L.dot(body.acceleration()), power, 0, roundoff));
    }
}

// L = Iω changes because ω does, by Ia, and because I turns with the body, by ω × L.
PROPERTY("in the world the angular momentum changes at the rate of the torque") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        Body body(draw);
        if (i % 4 == 0) body.torque = Vector3d::Zero();
        if (i % 4 == 1) body.make_round(0, 1);
        const Vector3d gained = body.times_tensor(body.acceleration());
        const Vector3d turned = body.omega.cross(body.times_tensor(body.omega));
        REQUIRE(close(gained + turned, body.torque, 0, 1e-12 * body.size()));
    }
}

PROPERTY("it is right for any body, however it spins, and with any torque or none") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        Body body(draw);
        body.inertia = draw.log(1e-12, 1e12) * draw_moments(draw, 100);
        if (i % 3 == 0) body.make_round(2, i % 2);
        if (i % 3 == 1)  // nearly a ball
            body.inertia = body.inertia[0] * Vector3d(1, 1 - draw.log(1e-8, 1e-2), 1 - draw.log(1e-8, 1e-2));
        const double speed = draw.log(1e-6, 1e6), moment = body.inertia[i % 3];
        body.omega = speed * draw_direction(draw);
        if (i % 4 == 0) body.q = Quaterniond::Identity();
        const double strength = draw.integer(0, 2) == 0 ? 0 : draw.log(1e-9, 1e9);
        body.torque = strength * moment * speed * speed * draw_direction(draw);
        REQUIRE(body.acceleration().allFinite());
        body.omega *= draw.any_of(0, 1e-3, {0});
        REQUIRE(body.acceleration().allFinite());
    }
}

// A rod's least moment is up to a million times less than the others, about any of its axes.
PROPERTY("it is right for long rods") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        Body body(draw);
        body.inertia = draw_rod(draw, draw.log(1e-9, 1e3), draw.spread(100, 1e6, i, 20));
        std::swap(body.inertia[0], body.inertia[i % 3]);
        const double speed = draw.log(1e-3, 1e3), moment = body.inertia[i / 3 % 3];
        body.omega = speed * draw_direction(draw);
        if (i % 4 == 0) body.q = Quaterniond::Identity();
        body.torque = (i % 5 == 0 ? 0 : draw.log(1e-3, 1e3)) * moment * speed * speed * draw_direction(draw);
        REQUIRE(body.acceleration().allFinite());
    }
}

PROPERTY("no moment, no spin and no torque is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        Body body(draw);
        body.inertia = draw.spread(1e-12, 1e12, i, 19) * draw_moments(draw, 100);
        const double speed = draw.spread(1e-12, 1e12, i, 20), strength = draw.spread(1e-12, 1e12, i, 21);
        body.omega = speed * draw_direction(draw);
        body.torque = strength * body.inertia.norm() * speed * speed * draw_direction(draw);
        REQUIRE(body.acceleration().allFinite());
    }
}
