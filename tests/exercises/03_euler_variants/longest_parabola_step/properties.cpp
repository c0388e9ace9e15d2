#include "longest_parabola_step.hpp"

#include "property.hpp"
#include "last_comparison.hpp"

// A part in a million off is near enough, and where no step is stable a search may end at a tiny
// one: the properties say how near, on both sides of the limit.
EXERCISE_WITHIN(longest_parabola_step, checker::many_are_right);

// By what a step multiplies in the long run: the larger root of the characteristic polynomial, of
// a matrix whose columns are what the step makes of (1, 0) and (0, 1).
static double growth(double omega, double zeta, double h) {
    const auto step = [&](double x, double u) {  // u = v/ω
        const double a = -omega * omega * x - 2 * zeta * omega * (u * omega);
        return std::array{x + h * u * omega + h * h * a / 2, u + h * a / omega};
    };
    const auto [xx, ux] = step(1, 0);
    const auto [xu, uu] = step(0, 1);
    const std::complex<double> half = (xx + uu) / 2;
    const std::complex<double> root = std::sqrt(half * half - (xx * uu - xu * ux));
    return std::max(std::abs(half + root), std::abs(half - root));
}

static bool dies_away(double omega, double zeta, double h) {
    return checker::below("In the long run a step of " + checker::in_words(h) + " multiplies the swing by",
                          growth(omega, zeta, h), 1);
}
static bool grows(double omega, double zeta, double h) {
    return checker::above("In the long run a step of " + checker::in_words(h) + " multiplies the swing by",
                          growth(omega, zeta, h), 1);
}

// With h = (1 ± 2e-6) limit a run shrinks or grows by 8 zeta² · 2e-6 a step at least: 2e-13 for the
// weakest damper, a thousand times the roundoff.
static double draw_zeta(Draw& draw) { return draw.log(1e-4, 20); }

PROPERTY("with any step below it a run dies away") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double omega = draw.log(1e-2, 1e3), zeta = draw_zeta(draw);
        const double longest = learner(omega, zeta);
        REQUIRE(longest > 0);
        for (const double share : {1e-3, 0.1, 0.5, 0.9, 1 - 2e-6}) REQUIRE(dies_away(omega, zeta, share * longest));
    }
}

PROPERTY("with a step a little longer a run grows") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double omega = draw.log(1e-2, 1e3), zeta = draw_zeta(draw);
        REQUIRE(grows(omega, zeta, learner(omega, zeta) * (1 + 2e-6)));
    }
}

PROPERTY("without damping no step is stable") {
    Draw draw;
    for (int i = 0; i < 10; ++i) {
        const double omega = draw.log(1e-2, 1e3);
        REQUIRE(close(learner(omega, 0) * omega, 0, 0, 1e-5));
    }
}

PROPERTY("the longest step is proportional to weak damping, and to one over strong damping") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double omega = draw.log(1e-2, 1e3), weak = draw.log(2e-4, 0.2);
        const double more = draw.real(1, 2), strong = draw.real(1, 5);
        REQUIRE(close(learner(omega, more * weak), more * learner(omega, weak), 3e-6));
        REQUIRE(close(learner(omega, more * strong), learner(omega, strong) / more, 3e-6));
    }
}

PROPERTY(
    "the limit is the limit for a hinge of hours and for one of microseconds, up to both ends of "
    "the damping") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double omega = draw.log(1e-6, 1e6), zeta = draw.any_of(1e-4, 20, {1e-4, 0.5, 1, 20});
        const double longest = learner(omega, zeta);
        REQUIRE(longest > 0);
        REQUIRE(dies_away(omega, zeta, longest * (1 - 2e-6)));
        REQUIRE(grows(omega, zeta, longest * (1 + 2e-6)));
    }
}

PROPERTY("no spring is too soft or too stiff for it, with any damping or none") {
    Draw draw;
    for (int i = 0; i < 240; ++i) {
        const double omega = draw.spread(1e-12, 1e12, i, 15), zeta = draw.spread(1e-4, 20, i, 16);
        const double longest = learner(omega, zeta);
        REQUIRE(dies_away(omega, zeta, longest * (1 - 2e-6)));
        REQUIRE(grows(omega, zeta, longest * (1 + 2e-6)));
        if (i % 4 == 0) REQUIRE(close(learner(omega, 0) * omega, 0, 0, 1e-5));
    }
}
