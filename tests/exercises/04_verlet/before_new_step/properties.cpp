#include "before_new_step.hpp"

#include "property.hpp"

EXERCISE(before_new_step);

// Roundoff here and below: terms of at most 1000 metres, as steps are at most ten times longer or
// shorter.
PROPERTY("where the step does not change, neither does the position before") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double before = draw.real(-10, 10), now = draw.real(-10, 10), a = draw.real(-20, 20);
        const double h = draw.log(1e-2, 1);
        REQUIRE(close(learner(before, now, a, h, h), before, 0, 1e-13));
    }
}

PROPERTY("a constant velocity comes out exactly, for shorter and longer steps") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double now = draw.real(-10, 10), v = draw.real(-10, 10);
        const double h_old = draw.log(0.1, 1), h_new = draw.log(0.1, 1);
        REQUIRE(close(learner(now - h_old * v, now, 0, h_old, h_new), now - h_new * v, 0, 1e-12));
    }
}

// A step a thousand times as long multiplies the roundoff of the last displacement by a thousand, and that of places in
// a parabola through three of them by half a million.
PROPERTY("a constant acceleration comes out exactly, be the step a thousand times as long") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double length = draw.log(1e-3, 1e6), ratio = draw.log(1e-3, 1e3);
        const double h_old = draw.log(1e-3, 1e3), h_new = ratio * h_old;
        const double longer = std::max(h_old, h_new);
        const double now = length * draw.real(-5, 5), v = length / longer * draw.real(-5, 5);
        const double a = length / (longer * longer) * draw.sign() * draw.real(1, 9);
        const auto ago = [&](double time) { return now - v * time + a * time * time / 2; };
        const double before = learner(ago(h_old), now, a, h_old, h_new);
        REQUIRE(close(before, ago(h_new), 0, 1e-14 * length * (10 + 10 * ratio + ratio * ratio)));
    }
}

// Steps long and short in turn; what differs from two comes from higher powers of the step.
PROPERTY("a run of Verlet on a spring with long and short steps in turn has order two") {
    Draw draw;
    for (int i = 0; i < 15; ++i) {
        const double omega = draw.real(1, 3), phase = draw.real(0.2, 0.5), end = 1 / omega;
        const double longer = draw.real(1.3, 1.6);
        const auto at = [&](double t) { return std::sin(omega * t + phase); };
        const auto error = [&](int steps) {
            const double mean = end / steps;
            double h = mean * longer, now = at(0), before = at(-h);
            for (int n = 0; n < steps; ++n) {
                const double h_new = mean * (n % 2 == 0 ? longer : 2 - longer);
                const double a = -omega * omega * now;
                before = learner(before, now, a, h, h_new);
                h = h_new;
                const double next = 2 * now - before + h * h * a;
                before = now;
                now = next;
            }
            return std::fabs(now - at(end));
        };
        const double measured = order(error(50), error(100));
        REQUIRE(measured > 1.8);
        REQUIRE(measured < 2.2);
    }
}

// Everything near zero now and then: there a term that is left out is all that there is.
PROPERTY("it is right wherever the task allows: at rest, nearly equal steps, tiny and huge ones") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double length = draw.log(1e-9, 1e6), h_old = draw.log(1e-6, 1e3);
        const double nearly = 1 + draw.sign() * draw.log(1e-11, 1e-2);
        const double ratio = i % 2 == 0 ? nearly : draw.any_of(1e-3, 1e3, {1e-3, 1, 1e3});
        const double now = length * draw.any_of(-5, 5, {0});
        const double before = now - length * draw.any_of(-5, 5, {0, 0});
        const double a = length / (h_old * h_old) * draw.any_of(-9, 9, {0});
        REQUIRE(std::isfinite(learner(before, now, a, h_old, ratio * h_old)));
    }
}

PROPERTY("no step and no way is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double length = draw.spread(1e-12, 1e12, i, 19), h_old = draw.spread(1e-12, 1e12, i, 20);
        const double h_new = std::clamp(h_old * draw.spread(1e-3, 1e3, i, 21), 1e-3 * h_old, 1e3 * h_old);
        const double now = length * draw.any_of(-5, 5, {0}), longer = std::max(h_old, h_new);
        const double a = length / (longer * longer) * draw.any_of(-9, 9, {0});
        REQUIRE(std::isfinite(learner(now - length * draw.any_of(-5, 5, {0}), now, a, h_old, h_new)));
    }
}
