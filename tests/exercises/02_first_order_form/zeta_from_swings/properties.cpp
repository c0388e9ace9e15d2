#include "zeta_from_swings.hpp"

#include "property.hpp"

EXERCISE(zeta_from_swings);

namespace {

using std::numbers::pi;

// What is left of a peak: e^(−ζωt) after n swings of the period 2π/(ω √(1 − ζ²)).
double left(double zeta, double swings) {
    return std::exp(-2 * pi * swings * zeta / std::sqrt((1 - zeta) * (1 + zeta)));
}

}  // namespace

PROPERTY("peaks that do not shrink mean no damping") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double peak = draw.sign() * draw.log(0.01, 100);
        REQUIRE(learner(peak, peak, draw.integer(1, 30)) == 0);
    }
}

// An error of 1e-15 in ζ is one of 2πn 1e-15/(1 − ζ²)^(3/2) in what is left: at most 2e-13 here.
PROPERTY("an oscillation with the ratio that comes out shrinks by just what was measured, in one period") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double first = draw.real(1, 100), part = draw.log(0.005, 0.999);
        const double zeta = learner(first, part * first, 1);
        REQUIRE(zeta > 0);
        REQUIRE(zeta < 1);
        REQUIRE(close(left(zeta, 1), part, 1e-12));
    }
}

PROPERTY("the unit of the heights and the side of the peaks make no difference") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double first = draw.real(1, 100), later = first * draw.real(0.01, 0.95);
        const double factor = draw.sign() * draw.log(1e-3, 1e3);
        const int swings = draw.integer(1, 10);
        const double zeta = learner(first, later, swings);
        REQUIRE(close(learner(factor * first, factor * later, swings), zeta, 1e-12));
        REQUIRE(close(learner(-first, -later, swings), zeta, 1e-12));
    }
}

// At ζ = 0.99 one period leaves e⁻⁴⁴, at 0.9998 e⁻³¹⁴. A relative error of the logarithm counts
// 1 − ζ² times in ζ.
PROPERTY("damping so strong that hardly anything is left still gives the right ratio, below 1") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double zeta = 1 - draw.log(2e-4, 0.2), first = draw.sign() * draw.real(1, 100);
        const double measured = learner(first, first * left(zeta, 1), 1);
        REQUIRE(measured < 1);
        REQUIRE(close(measured, zeta, 1e-12));
    }
}

// Nearly equal is not equal: a loss of a part in 10⁹ is a damping of 10⁻¹⁰. In each call the ratio must be the right
// one, as far as the two heights tell it.
PROPERTY("peaks that nearly agree and peaks of which hardly anything is left, in any unit, have their ratio") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double first = draw.sign() * draw.log(1e-9, 1e9);
        const double part = i % 2 == 0 ? 1 - draw.log(1e-9, 0.5) : draw.log(1e-90, 1);
        const int swings = i % 3 == 0 ? draw.integer(1, 5) : static_cast<int>(draw.log(1, 1e6));
        const double zeta = learner(first, part * first, swings);
        REQUIRE(zeta >= 0);
        REQUIRE(zeta < 1);
    }
}

PROPERTY("a billion periods may lie between two peaks, and of the first hardly anything may be left") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double first = draw.sign() * draw.spread(1e-12, 1e12, i, 19);
        const double part = i % 2 == 0 ? 1 - draw.spread(1e-11, 0.9, i / 2, 21) : draw.spread(1e-280, 1, i / 2, 21);
        const int swings = static_cast<int>(draw.spread(1, 1e9, i, 20));
        const double zeta = learner(first, part * first, i % 5 == 0 ? 1 : swings);
        REQUIRE(zeta >= 0);
        REQUIRE(zeta < 1);
    }
}
