#include "amplification.hpp"

#include "property.hpp"

// One part in 10⁹ is too much, says the task, so half of that is not.
constexpr double near_enough = 5e-10;
EXERCISE_WITHIN(amplification, near_enough);

namespace {

using Complex = std::complex<double>;

// What near enough makes of the answer: of 1 + (1 - theta) z, which may cancel, over what it is
// divided by.
double allowed(Complex z, double theta) {
    return near_enough * (1 + (1 - theta) * std::abs(z)) / std::abs(1.0 - theta * z);
}

// z of any direction; far enough from where the step has no answer, and from where R is zero.
Complex draw_z(Draw& draw, double theta, double low, double high) {
    for (;;) {
        const Complex z = std::polar(draw.log(low, high), draw.real(-4, 4));
        const double answer = std::abs(1.0 - theta * z), zero = std::abs(1.0 + (1 - theta) * z);
        if (answer > 0.05 && zero > 0.05) return z;
    }
}

double draw_step(Draw& draw) { return draw.log(1e-6, 100); }

double size(Complex z, double theta, double h) { return learner(z.real() / h, z.imag() / h, theta, h); }

}  // namespace

PROPERTY("a step of zero, and a motion that stands still, are multiplied by one") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double theta = draw.real(0, 1);
        REQUIRE(close(learner(draw.real(-100, 100), draw.real(-100, 100), theta, 0), 1, near_enough));
        REQUIRE(close(learner(0, 0, theta, draw_step(draw)), 1, near_enough));
    }
}

// The sign of y2 is not told.
PROPERTY("for a pure decay, y2 is what the equation of the method asks for") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double theta = draw.real(0, 1), h = draw_step(draw), y1 = 1;
        const double z = -draw.log(1e-6, 1e6), y2 = size(z, theta, h);
        const auto missing = [&](double y) { return std::fabs(y - y1 - ((1 - theta) * z * y1 + theta * z * y)); };
        REQUIRE(std::min(missing(y2), missing(-y2)) <= near_enough * (1 - z));
    }
}

PROPERTY("at the ends of the slider it is what explicit and implicit Euler multiply by") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double h = draw_step(draw);
        const Complex z = draw_z(draw, 0, 1e-6, 1e6), y1 = 1, explicit_y2 = y1 + z * y1;
        REQUIRE(close(size(z, 0, h), std::abs(explicit_y2), 0, allowed(z, 0)));
        const Complex w = draw_z(draw, 1, 1e-6, 1e6);  // y1 = y2 - z y2
        REQUIRE(close(std::abs(y1 - w * y1) * size(w, 1, h), 1, near_enough));
    }
}

PROPERTY("half way, an oscillation without damping keeps its size, and with damping it dies") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double h = draw_step(draw), swing = draw.sign() * draw.log(1e-6, 1e6);
        REQUIRE(close(size(Complex(0, swing), 0.5, h), 1, near_enough));
        const double part = draw.log(1e-3, 1);
        const Complex left(-part * std::fabs(swing), swing);
        if (std::abs(swing) > 1e-5 && std::abs(swing) < 1e5) REQUIRE(size(left, 0.5, h) < 1);
    }
}

// |1 + (1 - theta) z| = |1 - theta z| where 2 Re z + (1 - 2 theta) |z|² = 0.
PROPERTY("the border between growth and death is a circle through 0 and 2/(2 theta - 1)") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double theta = 0.5 + draw.sign() * draw.real(0.01, 0.5), h = draw_step(draw);
        const double centre = 1 / (2 * theta - 1);
        // From 0.1 on: near z = 0 inside and outside are too close to call.
        const Complex way = std::polar(1.0, draw.sign() * draw.real(0.1, 3.1));
        const auto at = [&](double radius) { return centre + radius * std::fabs(centre) * way; };
        REQUIRE(close(size(at(1), theta, h), 1, 0, 4 * allowed(at(1), theta)));
        // On the right the circle has the region of growth inside, on the left that of death.
        const double inside = size(at(0.99), theta, h), outside = size(at(1.01), theta, h);
        REQUIRE((theta > 0.5 ? inside > 1 : inside < 1));
        REQUIRE((theta > 0.5 ? outside < 1 : outside > 1));
    }
}

PROPERTY("it is right wherever the task allows: slow and fast rates, steps of any length, the slider's ends") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    const auto part = [&] { return draw.sign() * draw.any_of(1e-12, 7e5, {0, 1e-6, 1, 1e3, 1e5}); };
    for (int i = 0; i < 600; ++i) {
        const bool half_way = i % 10 == 5;  // nearly, and an oscillation that nothing damps
        const double theta = half_way ? 0.5 + draw.sign() * draw.log(1e-9, 1e-3)
                                      : draw.any_of(0, 1, {0, 0.5, 1, 1 - 1e-9, 0.5 + draw.sign() * 1e-9, 1e-9});
        const double h = draw.log(1e-9, 1e6);
        const double small = i % 2 == 0 ? 1 : draw.log(1e-9, 1e-3);
        const Complex z = small * Complex(half_way ? 0 : part(), part());
        if (std::abs(1.0 - theta * z) < 0.05) continue;
        const double factor = size(z, theta, h), first = std::abs(1.0 + (1 - theta) * z);
        all &= close(factor * std::abs(1.0 - theta * z), first, 1e-9, 1e-12 * (1 + (1 - theta) * std::abs(z)));
    }
    REQUIRE(all);
}

// Whoever multiplies the squares out takes 1 from nearly 1 here.
PROPERTY("where a step all but kills the motion, what is left has all its digits") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 60; ++i) {
        const double theta = draw.real(0, 0.9), h = draw_step(draw), left = draw.log(1e-5, 1e-2);
        const Complex z = (std::polar(left, draw.real(-4, 4)) - 1.0) / (1 - theta);
        all &= close(size(z, theta, h) * std::abs(1.0 - theta * z), left, 1e-9);
    }
    REQUIRE(all);
}

PROPERTY("no rate and no step is too small or too large for it, anywhere on the slider") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 420; ++i) {
        const double near = draw.spread(1e-12, 1, i / 3, 20);
        const double theta = i % 3 == 0 ? near : i % 3 == 1 ? 1 - near : draw.real(0, 1);
        const double h = draw.spread(1e-12, 1e12, i, 19), far = draw.spread(1e-12, 1e6, i, 21);
        const Complex z = draw_z(draw, theta, far, far);
        const double factor = size(z, theta, h), first = std::abs(1.0 + (1 - theta) * z);
        all &= close(factor * std::abs(1.0 - theta * z), first, 1e-9, 1e-12 * (1 + (1 - theta) * std::abs(z)));
    }
    REQUIRE(all);
}
