#include "position_before.hpp"

#include "property.hpp"

EXERCISE(position_before);

PROPERTY("at rest and without a force, a point was where it is") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double x = draw.real(-10, 10), h = draw.log(1e-3, 1);
        REQUIRE(close(learner(x, 0, 0, h), x, 1e-15));
    }
}

// Roundoff: a few terms of at most 20 metres.
PROPERTY("without a force, Verlet's next step goes on at the given velocity") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), v = draw.real(-10, 10), h = draw.log(1e-2, 1);
        const double next = 2 * x - learner(x, v, 0, h);
        REQUIRE(close(next, x + h * v, 0, 1e-13));
    }
}

PROPERTY("let go at rest under a force, Verlet's first step falls as far as a stone falls") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), a = draw.sign() * draw.real(1, 20);
        const double h = draw.log(0.1, 1);
        const double next = 2 * x - learner(x, 0, a, h) + h * h * a;
        REQUIRE(close(next, x + a * h * h / 2, 0, 1e-13));
    }
}

PROPERTY("with a constant acceleration it lies on the parabola of the throw") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double start = draw.real(-5, 5), launch = draw.real(-10, 10), a = draw.real(-20, 20);
        const double t = draw.real(0, 2), h = draw.log(1e-2, 1);
        const auto at = [&](double time) { return start + launch * time + a * time * time / 2; };
        REQUIRE(close(learner(at(t), launch + a * t, a, h), at(t - h), 0, 1e-12));
    }
}

PROPERTY("a run of Verlet on a spring, started from it, has order two") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        // Verlet runs ahead by (ωh)²/24 of the phase, and the oscillation that the velocity starts is too
        // large by (ωh)²/8: at these phases the two do not cancel.
        const double omega = draw.real(1, 3), phase = draw.real(0.2, 0.5), end = 1 / omega;
        const auto error = [&](int steps) {
            const double h = end / steps;
            double now = std::sin(phase);
            double before = learner(now, omega * std::cos(phase), -omega * omega * now, h);
            for (int n = 0; n < steps; ++n) {
                const double next = 2 * now - before - h * h * omega * omega * now;
                before = now;
                now = next;
            }
            return std::fabs(now - std::sin(omega * end + phase));
        };
        const double measured = order(error(100), error(200));
        REQUIRE(measured > 1.9);
        REQUIRE(measured < 2.1);
    }
}

// Everything zero or near it now and then: there a term that is left out is all that there is.
PROPERTY("it is right wherever the task allows: at rest, at zero, for tiny and for huge steps") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double length = draw.log(1e-9, 1e6), h = draw.log(1e-6, 1e6);
        const double x = length * draw.any_of(-5, 5, {0}), v = length / h * draw.any_of(-5, 5, {0});
        const double a = length / (h * h) * draw.any_of(-9, 9, {0});
        REQUIRE(std::isfinite(learner(x, v, a, h)));
    }
}

PROPERTY("no step, no way and no speed is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double length = draw.spread(1e-12, 1e12, i, 20), h = draw.spread(1e-12, 1e12, i, 21);
        const double x = length * draw.any_of(-5, 5, {0}), v = length / h * draw.any_of(-5, 5, {0});
        REQUIRE(std::isfinite(learner(x, v, length / (h * h) * draw.any_of(-9, 9, {0}), h)));
    }
}
