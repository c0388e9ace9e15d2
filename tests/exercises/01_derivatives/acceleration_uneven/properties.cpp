#include "acceleration_uneven.hpp"

#include "property.hpp"

EXERCISE(acceleration_uneven);

// The weights on the positions are at most 4/(h0 h1) together; positions of up to `size` metres are
// rounded by half an epsilon of that, before and in the formula.
static double roundoff(double size, double h0, double h1) { return 1e-15 * size * 20 / (h0 * h1); }

PROPERTY("a body at rest has no acceleration, wherever it is") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double x = draw.real(-10, 10), h0 = draw.log(0.01, 1), h1 = draw.log(0.01, 1);
        REQUIRE(close(learner(x, x, x, h0, h1), 0, 0, roundoff(10, h0, h1)));
    }
}

PROPERTY("a constant velocity has no acceleration, however uneven the frames") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), v = draw.sign() * draw.real(1, 10);
        const double h0 = draw.log(0.01, 1), h1 = h0 * draw.log(0.2, 5);
        REQUIRE(close(learner(x - v * h0, x, x + v * h1, h0, h1), 0, 0, roundoff(60, h0, h1)));
    }
}

PROPERTY("a constant acceleration comes out exactly when the frames are even") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-5, 5), v = draw.real(-5, 5), a = draw.real(-9, 9);
        const double h = draw.log(0.01, 1);
        const auto at = [&](double t) { return x + v * t + a * t * t / 2; };
        REQUIRE(close(learner(at(-h), x, at(h), h, h), a, 0, roundoff(20, h, h)));
    }
}

PROPERTY("a constant acceleration comes out exactly when the frames are uneven") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-5, 5), v = draw.real(-5, 5), a = draw.real(-9, 9);
        const double h0 = draw.log(0.01, 1), h1 = h0 * draw.log(0.2, 5);
        const auto at = [&](double t) { return x + v * t + a * t * t / 2; };
        REQUIRE(close(learner(at(-h0), x, at(h1), h0, h1), a, 0, roundoff(150, h0, h1)));
    }
}

// The error begins with (h1 − h0)/3 times the jerk, which is not small at these phases, and goes on
// with (h0² − h0 h1 + h1²)/12 times the fourth derivative.
static double measured_order(Draw& draw, double ratio, double phase) {
    const double omega = draw.real(1, 3);
    const auto error = [&](double h) {
        const auto at = [&](double t) { return std::sin(omega * t + phase); };
        const double a = learner(at(-h), at(0), at(ratio * h), h, ratio * h);
        return std::fabs(a + omega * omega * std::sin(phase));
    };
    return order(error(0.02 / omega), error(0.01 / omega));
}

PROPERTY("on a smooth motion the error falls as the square of the step when the frames are even") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double measured = measured_order(draw, 1, draw.sign() * draw.real(0.7, 1.5));
        REQUIRE(measured > 1.9);
        REQUIRE(measured < 2.1);
    }
}

// In each call the answer must be the right one: where the intervals differ by little, where one of
// them is tiny, where the body comes back to a place.
PROPERTY(
    "any three positions and any two intervals give an acceleration: equal, nearly equal, or far "
    "from it") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double length = draw.log(1e-9, 1e9), h0 = draw.log(1e-6, 1e6);
        const double near = 1 + draw.sign() * draw.log(1e-9, 0.1), far = draw.log(1e-4, 1e4);
        const double h1 = h0 * (i % 3 == 0 ? 1 : i % 3 == 1 ? near : far);
        std::array<double, 3> x{};
        for (double& one : x) one = length * draw.any_of(-5, 5, {0, 1});
        REQUIRE(std::isfinite(learner(x[0], x[1], x[2], h0, h1)));
    }
}

PROPERTY("intervals from a billionth of a millisecond to ages, and ways of atoms and of stars, have theirs, too") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double h0 = draw.spread(1e-12, 1e12, i, 20), h1 = draw.spread(1e-12, 1e12, i, 21);
        const double length = draw.spread(1e-12, 1e12, i, 19);
        std::array<double, 3> x{};
        for (double& one : x) one = length * draw.any_of(-5, 5, {0, 1});
        if (i % 4 == 0) x[i % 8 / 4] = x[1 + i % 8 / 4] * (1 + draw.sign() * draw.log(1e-12, 1e-2));
        REQUIRE(std::isfinite(learner(x[0], x[1], x[2], h0, h1)));
    }
}

PROPERTY("the acceleration of a body far from the origin is right, however slow the body is") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double h0 = draw.spread(1e-4, 1e4, i, 21), h1 = h0 * draw.log(0.1, 10);
        const double far = draw.sign() * draw.spread(1e-6, 1e9, i, 20),
                     way = std::fabs(far) * draw.spread(1e-12, 1, i, 19);
        const double x0 = far + way * draw.real(-5, 5), x1 = far + way * draw.real(-5, 5);
        REQUIRE(std::isfinite(learner(x0, x1, far + way * draw.real(-5, 5), h0, h1)));
    }
}
