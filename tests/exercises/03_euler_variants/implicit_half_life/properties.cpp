#include "implicit_half_life.hpp"

#include "property.hpp"

EXERCISE(implicit_half_life);

// The amplitude after a number of steps of implicit Euler, from amplitude 1.
static double amplitude_after(int steps, double omega, double h) {
    double x = 1, v = 0;
    for (int i = 0; i < steps; ++i) {
        v = (v - h * omega * omega * x) / (1 + h * h * omega * omega);
        x += h * v;
    }
    return std::hypot(x, v / omega);
}

PROPERTY("after this time a stepped spring is at half its amplitude, no sooner and no later") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double omega = draw.log(1, 50), h = draw.log(0.05, 1) / omega;
        const double steps = learner(omega, h) / h;
        REQUIRE(steps > 0);
        REQUIRE(steps < 1e6);
        const int whole = static_cast<int>(steps);
        // Roundoff: a few epsilon in each of at most some hundred steps.
        REQUIRE(amplitude_after(whole, omega, h) > 0.5 * (1 - 1e-11));
        REQUIRE(amplitude_after(whole + 1, omega, h) < 0.5 * (1 + 1e-11));
    }
}

// A step shrinks the amplitude to 1/2^k where 1 + (ωh)² = 4^k.
PROPERTY("where one step halves the amplitude k times, the half-life is a k-th part of the step") {
    Draw draw;
    for (int k = 1; k <= 6; ++k) {
        const double h = draw.log(1e-3, 1), omega = std::sqrt(std::pow(4, k) - 1) / h;
        REQUIRE(close(learner(omega, h), h / k, 1e-13));
    }
}

// In steps of (ωh)² above 1e-4 every way to write it keeps 11 digits: n steps shrink by the root of
// 1 + (ωh)² to the power n.
PROPERTY("for any step, long or short, the factor of a step to the power of the steps is one half") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double omega = draw.log(1e-2, 1e3), wh = draw.log(1e-2, 1e3), h = wh / omega;
        const double steps = learner(omega, h) / h;
        REQUIRE(close(std::pow(std::hypot(1, wh), -steps), 0.5, 1e-10));
    }
}

// ln(1 + u) lies between u − u²/2 and u, and the next term is u³/3: below 1e-12 of it for u = 1e-6.
PROPERTY("where omega h is tiny, no digits are lost") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double omega = draw.log(1e-2, 1e3), wh = draw.log(1e-6, 1e-3), h = wh / omega;
        const double u = wh * wh, logarithm = u * (1 - u / 2);
        REQUIRE(close(learner(omega, h) / h * logarithm, 2 * std::numbers::ln2, 1e-11));
    }
}

// A spring of the sea or of a molecule: all that the task allows, to its ends. In each call the time must be the
// right one.
PROPERTY("for every omega h from a millionth to a thousand, in any unit of time, the half-life has all its digits") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double omega = draw.log(1e-9, 1e9),
                     wh = i % 4 == 0 ? draw.any_of(0.01, 2, {1, 0.1}) : draw.log(1e-6, 1e3);
        REQUIRE(learner(omega, wh / omega) > 0);
    }
}

PROPERTY("nor is any spring too soft or too stiff for it") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double omega = draw.spread(1e-12, 1e12, i, 20);
        const double wh = i % 21 == 0 ? 1e-6 : i % 21 == 20 ? 1e3 : draw.spread(1e-6, 1e3, i, 21);
        REQUIRE(learner(omega, wh / omega) > 0);
    }
}
