#include "order_of_results.hpp"

#include "property.hpp"

EXERCISE(order_of_results);

// Three results whose error is C hᵖ, C of either sign. The smaller of their differences is at least
// 0.1 · 2⁻ᵖ (1 − 2⁻ᵖ): above 1e-3 for p up to 6, against a roundoff of 1e-15 times their size.
static std::array<double, 3> results(double exact, double error, double p) {
    return {exact + error, exact + error * std::pow(2, -p), exact + error * std::pow(4, -p)};
}

static double order_of(const std::array<double, 3>& r) { return learner(r[0], r[1], r[2]); }

PROPERTY("errors that halve with the step have order one") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double exact = draw.real(-10, 10), error = draw.sign() * draw.real(0.1, 1);
        REQUIRE(close(order_of(results(exact, error, 1)), 1, 1e-11));
    }
}

PROPERTY("an error that is a power of the step has that power for its order") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double exact = draw.real(-10, 10), error = draw.sign() * draw.real(0.1, 1);
        const int p = draw.integer(2, 6);
        REQUIRE(close(order_of(results(exact, error, p)), p, 1e-10));
    }
}

PROPERTY("an order that is not a whole number is found as well") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double exact = draw.real(-10, 10), error = draw.sign() * draw.real(0.1, 1);
        const double p = draw.real(0.3, 6);
        REQUIRE(close(order_of(results(exact, error, p)), p, 1e-10));
    }
}

// The largest of the three is up to 2⁸ times the error, the smaller difference 0.02 at least.
PROPERTY("errors that grow when the step shrinks have an order below zero") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double exact = draw.real(-10, 10), error = draw.sign() * draw.real(0.1, 1);
        const double p = draw.real(-4, -0.3);
        REQUIRE(close(order_of(results(exact, error, p)), p, 1e-10));
    }
}

PROPERTY("the order does not change when the results are shifted, scaled or mirrored") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double shift = draw.real(-10, 10), scale = draw.sign() * draw.log(0.1, 10);
        const double error = draw.sign() * draw.real(0.5, 1);
        const auto r = results(draw.real(-1, 1), error, draw.real(0.5, 4));
        const auto moved = [&](double x) { return shift + scale * x; };
        const double before = order_of(r), after = learner(moved(r[0]), moved(r[1]), moved(r[2]));
        REQUIRE(close(before, after, 1e-9));
    }
}

// Errors down to 1e-8 of the results, in units from a billionth to a billion: the differences have
// a few digits left, or all where the exact value is zero. In each call the answer must be the
// order of the three results.
PROPERTY(
    "three results of any unit have an order, also where they nearly agree, and where it is "
    "small") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double unit = draw.log(1e-9, 1e9), error = draw.sign() * draw.log(1e-8, 1);
        const double p = i % 3 == 0 ? draw.integer(1, 6) : draw.sign() * draw.log(0.1, i % 3 == 1 ? 6 : 1.2);
        const auto r = results(draw.any_of(-10, 10, {0}), error, p);
        REQUIRE(std::isfinite(learner(unit * r[0], unit * r[1], unit * r[2])));
    }
}

// The exact value is zero: nothing hides an error. Below zero it is the difference of results that are far larger
// than the middle one, if somebody finds it first.
PROPERTY("high orders and tiny ones, above zero and below, in any unit, are found as well") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double unit = draw.sign() * draw.spread(1e-12, 1e12, i, 20);
        const double sign = draw.sign(), p = sign * draw.spread(1e-3, sign > 0 ? 30 : 10, i, 21);
        const auto r = results(0, 1, p);
        REQUIRE(close(learner(unit * r[0], unit * r[1], unit * r[2]), p, 1e-6));
    }
}
