#include "half_step_jacobian.hpp"

#include "property_eigen.hpp"

// Twelve digits count, says the task.
EXERCISE_WITHIN(half_step_jacobian, checker::all_digits);

struct Tumble {
    Vector3d inertia, omega;
    double h;

    Vector3d after() const { return learner(inertia, omega, h); }
};

static Vector3d torque(const Vector3d& inertia, const Vector3d& omega) {
    return -omega.cross(inertia.cwiseProduct(omega));
}

static double energy(const Vector3d& inertia, const Vector3d& omega) {
    return omega.dot(inertia.cwiseProduct(omega)) / 2;
}

// The size of h ω lies between the two that are given.
static Tumble draw_tumble(Draw& draw, double least, double most) {
    const double speed = draw.log(0.1, 50);
    return {draw_moments(draw, 20), speed * draw_direction(draw), draw.log(least, most) / speed};
}

// Three clearly different moments of a body that can be, so that there is a tumble to see.
static Vector3d draw_uneven(Draw& draw) {
    const double least = draw.real(0.62, 0.7), middle = draw.real(0.9, 1.1);
    Vector3d moments(least, middle, draw.real(1.3, 1.5));
    std::swap(moments[0], moments[draw.integer(0, 2)]);
    std::swap(moments[1], moments[draw.integer(1, 2)]);
    return draw.log(0.01, 100) * moments;
}

// Up to the energy of a long tumble a few digits will do: where mistakes answer alike, single
// precision should not be taken for one of them.
PROPERTY("a spin about a principal axis stays, and any spin of a ball, and any in a step of zero") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Tumble t = draw_tumble(draw, 0.01, 0.6);
        t.omega = draw.sign() * t.omega.norm() * Vector3d::Unit(i % 3);
        REQUIRE(close(t.after(), t.omega, 1e-5));
        Tumble ball = draw_tumble(draw, 0.01, 0.6);
        ball.inertia.setConstant(ball.inertia[i % 3]);
        REQUIRE(close(ball.after(), ball.omega, 1e-5));
        Tumble pause = draw_tumble(draw, 0.01, 0.6);
        pause.h = 0;
        REQUIRE(close(pause.after(), pause.omega, 1e-5));
    }
}

PROPERTY("a step of h and then a step of -h lead back to the beginning") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Tumble t = draw_tumble(draw, 0.3, 0.6);
        REQUIRE(close(learner(t.inertia, t.after(), -t.h), t.omega, 1e-4));
    }
}

PROPERTY("the energy of a long tumble stays within a hundredth: it oscillates and does not drift") {
    Draw draw;
    for (int i = 0; i < 3; ++i) {
        const Vector3d inertia = draw_uneven(draw), begin = draw_direction(draw);
        Vector3d omega = begin;
        for (int j = 0; j < 500; ++j) {
            omega = learner(inertia, omega, 0.1);
            REQUIRE(close(energy(inertia, omega), energy(inertia, begin), 0.01));
        }
    }
}

// The torque is quadratic: its differences to both sides give the slope of the tangent without an
// error, however far they reach. Roundoff times the ratio of the moments is below 1e-13.
PROPERTY("I omega changes by h times the mean of the two torques, that of the end linearised") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        Tumble t = draw_tumble(draw, 0.01, 0.6);
        t.h *= draw.sign();
        const Vector3d d = t.after() - t.omega;
        const Vector3d begin = torque(t.inertia, t.omega);
        const Vector3d rise = (torque(t.inertia, t.omega + d) - torque(t.inertia, t.omega - d)) / 2;
        const Vector3d expected = t.h * (begin + rise / 2).cwiseQuotient(t.inertia);
        REQUIRE(close(d, expected, 0, 1e-12 * t.omega.norm()));
    }
}

PROPERTY("it is right for any body, tiny or huge, any plate, any spin or none, and any step") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        Vector3d inertia = draw.log(1e-12, 1e12) * draw_moments(draw, 1000);
        const int one = i / 3 % 3, other = (one + 1) % 3;
        if (i % 3 == 0) inertia[one] = inertia[other] = inertia.maxCoeff();
        if (i % 6 == 0) inertia[i / 6 % 2 == 0 ? one : other] *= 1 - draw.log(1e-11, 1e-3);
        if (i % 5 == 0) inertia[i % 3] = inertia[(i + 1) % 3] + inertia[(i + 2) % 3];
        const double speed = draw.log(1e-6, 1e6), h = draw.any_of(-0.95, 0.95, {0}) / speed;
        Vector3d omega = speed * draw_direction(draw);
        if (i % 4 == 0) omega[i % 3] *= draw.any_of(0, 1e-3, {0});
        // Nearly about an axis, where a flip begins.
        if (i % 4 == 1) omega = speed / 1.02 * (Vector3d::Unit(i % 3) + draw.log(1e-9, 1e-2) * draw_direction(draw));
        REQUIRE(learner(inertia, omega, h).allFinite());
        REQUIRE(learner(inertia, Vector3d::Zero(), h).norm() == 0);
    }
}

PROPERTY("no moment and no spin is too small or too large for it, and no step too short or too long") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const Vector3d inertia = draw.spread(1e-12, 1e12, i, 19) * draw_moments(draw, 1000);
        const double speed = draw.spread(1e-12, 1e12, i, 20), turn = draw.sign() * draw.spread(1e-9, 0.95, i, 21);
        REQUIRE(learner(inertia, speed * draw_direction(draw), turn / speed).allFinite());
    }
}
