#include "extrapolated.hpp"

#include "property.hpp"

EXERCISE(extrapolated);

// The weights on the two results are r/(r − 1) and 1/(r − 1), r = ratioᵖ: with the ratio above 1.25
// they are 9 together at the most, and more nearer to 1.
static double roundoff(double size) { return 1e-14 * size; }

// The exact values that are drawn are not zero: there an answer would be nothing but the roundoff
// of a coarse result that may be 10⁴⁰ times as large as the fine one.

PROPERTY("two equal results are left as they are") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double both = draw.sign() * draw.real(1, 10);
        const double answer = learner(both, both, draw.real(1.25, 5), draw.integer(1, 6));
        REQUIRE(close(answer, both, 0, roundoff(10)));
    }
}

PROPERTY("with steps in any ratio, an error that is a power of the step vanishes") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double exact = draw.sign() * draw.real(1, 10), error = draw.sign() * draw.real(0.5, 2);
        const double ratio = draw.real(1.25, 5);
        const int p = draw.integer(1, 6);
        const double answer = learner(exact + error, exact + error * std::pow(ratio, -p), ratio, p);
        REQUIRE(close(answer, exact, 0, roundoff(20)));
    }
}

PROPERTY("an error of any order vanishes, be the ratio of the steps near 1 or far from it") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double exact = draw.sign() * draw.real(1, 10), error = draw.sign() * draw.real(0.5, 2);
        const double ratio = 1 + draw.log(1e-3, 100);
        const int p = draw.integer(1, 20);
        const double answer = learner(exact + error, exact + error * std::pow(ratio, -p), ratio, p);
        REQUIRE(close(answer, exact, 0, roundoff(20) * (1 + 1 / (ratio - 1))));
    }
}

PROPERTY("shifting and scaling both results shifts and scales the answer") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double coarse = draw.real(-1, 1), fine = draw.real(-1, 1), ratio = draw.real(1.25, 5);
        const double shift = draw.real(-10, 10), scale = draw.sign() * draw.log(0.1, 10);
        const int p = draw.integer(1, 4);
        const double answer = learner(coarse, fine, ratio, p);
        const double moved = learner(shift + scale * coarse, shift + scale * fine, ratio, p);
        REQUIRE(close(moved, shift + scale * answer, 0, roundoff(100)));
    }
}

// The two results may agree to any digit, be of any unit, and fall or rise. In each call the answer
// must be the right one.
PROPERTY(
    "results that nearly agree, however small they are, are made better as well, by any ratio and "
    "order") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double coarse = draw.sign() * draw.log(1e-9, 1e9);
        const double apart = draw.any_of(-0.5, 0.9, {0, 1e-6, -1e-6}), fine = coarse * (1 + apart);
        const double ratio = i % 3 == 0 ? draw.integer(2, 10) : 1 + draw.log(1e-3, 10);
        REQUIRE(std::isfinite(learner(coarse, fine, ratio, draw.integer(1, 12))));
    }
}

// Of order 30, a step a billionth as long has an error that is smaller by 10²⁷⁰: still a double.
PROPERTY("no ratio and no order is too large for it, and no result too small or too large") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double coarse = draw.sign() * draw.spread(1e-12, 1e12, i, 19);
        const double fine = coarse * (1 + draw.any_of(-0.5, 0.9, {0, 1e-6, -1e-6}));
        const double ratio = i % 20 == 0 ? 1.001 : 1 + draw.spread(1e-3, 1e9, i, 20);
        REQUIRE(std::isfinite(learner(coarse, fine, ratio, 1 + i % 21 + (i % 2 == 0 ? 9 : 0))));
        // One of the two is zero, or they lie on two sides of it: of an error that falls a thousandfold at most.
        const double near = 1 + draw.spread(1e-3, 1, i, 20);
        const double other = coarse * draw.any_of(-3, 0, {0});
        REQUIRE(std::isfinite(learner(coarse, other, near, draw.integer(1, 8))));
        if (i % 4 == 0) REQUIRE(std::isfinite(learner(0, coarse, near, draw.integer(1, 8))));
    }
}
