#include "farthest_reach.hpp"

#include "property.hpp"

// Another way to write it takes the velocity from two positions in a row: a roundoff of ε/(ωh), and
// ωh is 10⁻¹⁰ at the least. Where ωh is longer the last property asks for all the digits that this leaves.
EXERCISE_WITHIN(farthest_reach, 1e-4);

static State<double> step(const State<double>& s, double omega, double h) {
    const double v2 = s.v - h * omega * omega * s.x;
    return {s.t + h, s.x + h * v2, v2};
}

PROPERTY("a spring at rest in the middle stays there: zero") {
    Draw draw;
    for (int i = 0; i < 10; ++i) {
        const double omega = draw.log(0.5, 50);
        REQUIRE(close(learner(0, 0, omega, draw.real(0.05, 1.9) / omega), 0, 0, 1e-15));
    }
}

// Roundoff: the largest state is some ten times the smallest part of the energy, at ωh = 1.9.
PROPERTY("each state of a run gives the same answer") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double omega = draw.log(0.5, 50), h = draw.real(0.05, 1.9) / omega;
        State<double> s{0, draw.real(-2, 2), draw.real(-2, 2) * omega};
        const double reach = learner(s.x, s.v, omega, h);
        for (int n = 0; n < 10; ++n) {
            s = step(s, omega, h);
            REQUIRE(close(learner(s.x, s.v, omega, h), reach, 1e-11));
        }
    }
}

PROPERTY("no position of a run is farther") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double omega = draw.log(0.5, 50), h = draw.real(0.05, 1.9) / omega;
        State<double> s{0, draw.real(-2, 2), draw.real(-2, 2) * omega};
        const double reach = learner(s.x, s.v, omega, h);
        for (int n = 0; n < 1000; ++n) {
            s = step(s, omega, h);
            REQUIRE(std::fabs(s.x) <= reach * (1 + 1e-10));
        }
    }
}

// x before is x − h v, and x after is x + h (v − h ω² x): the same for this v.
PROPERTY("a run that goes back where it came from has been at its farthest in between") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double omega = draw.log(0.5, 50), h = draw.real(0.05, 1.9) / omega;
        const double x = draw.sign() * draw.real(0.5, 2), v = h * omega * omega * x / 2;
        REQUIRE(close(learner(x, v, omega, h), std::fabs(x), 1e-12));
    }
}

// At ωh = 1 a step goes on by π/3 along the cosine that it samples, and the velocity is the
// difference to the position before, over h.
PROPERTY("all of the ellipse counts, even at omega h = 1, where a run has but six states") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double omega = draw.log(0.5, 50), h = 1 / omega;
        const double reach = draw.real(0.5, 2), phase = draw.real(0, 2 * std::numbers::pi);
        const double x = reach * std::cos(phase);
        const double before = reach * std::cos(phase - std::numbers::pi / 3);
        REQUIRE(close(learner(x, (x - before) / h, omega, h), reach, 1e-12));
    }
}

// As a sum of two squares, one of x alone: it loses no digits. Roundoff: that of two positions in a row, and of
// 1 − ω²h²/4 near ωh = 2.
PROPERTY("tiny swings and huge ones, tiny steps and those near omega h = 2, have their ellipse") {
    Draw draw;
    for (int i = 0; i < 600; ++i) {
        const double omega = draw.spread(1e-9, 1e9, i, 19), size = draw.spread(1e-12, 1e12, i, 21);
        const double wh = i % 4 == 0   ? 2 - draw.spread(1e-6, 1, i / 4, 20)
                          : i % 4 == 1 ? draw.spread(1e-10, 1, i / 4, 20)
                                       : draw.any_of(0.01, 1.99, {1, 0.5});
        const double x = size * draw.any_of(-2, 2, {0, 1}), v = omega * size * draw.any_of(-2, 2, {0, 1});
        const double h = wh / omega, rest = v / omega - omega * h * x / 2;
        const double right = std::hypot(x, rest / std::sqrt((1 - omega * h / 2) * (1 + omega * h / 2)));
        REQUIRE(close(learner(x, v, omega, h), right, 3e-15 / wh + 2e-14 / (2 - wh)));
    }
}
