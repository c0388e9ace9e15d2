#include "velocity_now.hpp"

#include "property.hpp"

EXERCISE(velocity_now);

PROPERTY("a body at rest has velocity zero, wherever it is") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double x = draw.real(-10, 10), h = draw.log(1e-3, 1);
        REQUIRE(close(learner(x, x, x, h), 0, 0, 1e-14 / h));
    }
}

// Roundoff: weights 3, 4 and 1 over 2h, each position rounded by half an epsilon of its size.
PROPERTY("a constant velocity comes out exactly, for any step") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), v = draw.real(-10, 10), h = draw.log(1e-3, 1);
        REQUIRE(close(learner(x - 2 * v * h, x - v * h, x, h), v, 0, 1e-14 * (10 + 20 * h) / h));
    }
}

PROPERTY("a constant acceleration gives exactly the velocity at the newest frame") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-5, 5), v = draw.real(-5, 5), a = draw.real(-9, 9);
        const double h = draw.log(1e-2, 1);
        const auto at = [&](double t) { return x + v * t + a * t * t / 2; };
        REQUIRE(close(learner(at(-2 * h), at(-h), x, h), v, 0, 1e-14 * 40 / h));
    }
}

PROPERTY("the error on a smooth motion falls as the square of the step") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        // The error begins with h² x‴/3; at these phases the third derivative is not small.
        const double omega = draw.real(1, 3), phase = draw.real(-0.5, 0.5);
        const auto error = [&](double h) {
            const auto at = [&](double t) { return std::sin(omega * t + phase); };
            return std::fabs(learner(at(-2 * h), at(-h), at(0), h) - omega * std::cos(phase));
        };
        const double measured = order(error(0.01 / omega), error(0.005 / omega));
        REQUIRE(measured > 1.9);
        REQUIRE(measured < 2.1);
    }
}

// Lengths from a millimetre to a thousand kilometres, steps from a tenth of a millisecond to hours.
// Each position is of a few lengths.
PROPERTY("a constant acceleration comes out exactly in a game of any size and with any step") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double length = draw.log(1e-3, 1e6), h = draw.log(1e-4, 1e4);
        const double x = length * draw.real(-5, 5), v = length / h * draw.sign() * draw.real(1, 5);
        const double a = length / (h * h) * draw.sign() * draw.real(1, 9);
        const auto at = [&](double t) { return x + v * t + a * t * t / 2; };
        REQUIRE(close(learner(at(-2 * h), at(-h), x, h), v, 0, 1e-14 * 80 * length / h));
    }
}

// Whole numbers among them, and places in which the body has been before. What is looked for here
// is in each call: is the answer the right one?
PROPERTY(
    "three frames of any size give a velocity: near or far, slow or fast, standing in one of them "
    "or not") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double length = draw.spread(1e-12, 1e12, i, 20), h = draw.spread(1e-12, 1e12, i, 21);
        std::array<double, 3> x{};
        for (double& one : x) one = length * draw.any_of(-5, 5, {0, 1});
        if (i % 3 == 0) x[1] = x[2] * (1 + draw.sign() * draw.log(1e-9, 1e-2));
        REQUIRE(std::isfinite(learner(x[0], x[1], x[2], h)));
    }
}

// All three positions lie as far from the origin as they like, beside the way between them: a level of some kilometres,
// and a body that creeps. What roundoff of the positions leaves must be right.
PROPERTY("the velocity of a body far from the origin is right, however slow the body is") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double h = draw.spread(1e-4, 1e4, i, 21), far = draw.sign() * draw.spread(1e-6, 1e9, i, 20);
        const double way = std::fabs(far) * draw.spread(1e-12, 1, i, 19);
        const double x0 = far + way * draw.real(-5, 5), x1 = far + way * draw.real(-5, 5);
        REQUIRE(std::isfinite(learner(x0, x1, far + way * draw.real(-5, 5), h)));
    }
}
