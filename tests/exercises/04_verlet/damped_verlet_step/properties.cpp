#include "damped_verlet_step.hpp"

#include "property.hpp"

// The constants of the exact path, of which some answers are made, are larger than a displacement by
// 1/(gamma h), a million times here at most; so is their roundoff.
EXERCISE_WITHIN(damped_verlet_step, 1e-9);

PROPERTY("without drag it is Verlet's step") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double before = draw.real(-10, 10), now = draw.real(-10, 10), a = draw.real(-20, 20);
        const double h = draw.log(1e-2, 1);
        REQUIRE(close(learner(before, now, a, 0, h), 2 * now - before + h * h * a, 0, 1e-13));
    }
}

PROPERTY("at rest and without a force a point stays where it is") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), gamma = draw.log(0.01, 100), h = draw.log(1e-2, 1);
        REQUIRE(close(learner(x, x, 0, gamma, h), x, 1e-15));
    }
}

// Both runs start with the same velocity, in the middle of a step of their own: what is left of it
// after a second, over what it was, is compared.
PROPERTY("a velocity that nothing drives dies down in a second as much at 30 Hz as at 60 Hz") {
    Draw draw;
    for (int i = 0; i < 15; ++i) {
        const double x = draw.real(-1, 1), v = draw.sign() * draw.real(1, 5);
        const double gamma = draw.log(0.1, 5);
        const auto left_after_a_second = [&](int rate) {
            const double h = 1.0 / rate;
            double before = x - h * v, now = x;
            for (int n = 0; n < rate; ++n) {
                const double next = learner(before, now, 0, gamma, h);
                before = now;
                now = next;
            }
            return (now - before) / (h * v);
        };
        const double slow = left_after_a_second(30), fast = left_after_a_second(60);
        REQUIRE(close(slow, fast, 0, 1e-8));
        // Its rate of change is gamma times itself.
        REQUIRE(close(-std::log(slow), gamma, 1e-8));
    }
}

PROPERTY("a body that falls so fast that the drag balances the force keeps its velocity") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double x = draw.real(-10, 10), a = draw.sign() * draw.real(1, 20);
        const double gamma = draw.log(0.1, 100), h = draw.log(1e-2, 1), way = h * a / gamma;
        const double next = learner(x - way, x, a, gamma, h);
        REQUIRE(close(next, x + way, 0, 1e-12 * (1 + std::fabs(way))));
    }
}

// Answers may take what is left from one, with a roundoff of 1e-16: what e^-20 leaves is still seen.
PROPERTY("a velocity that nothing drives dies down exponentially, also where little of it is left") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double gamma = draw.log(0.01, 100), h = draw.real(0.1, 20) / gamma;
        REQUIRE(close(learner(0, 1, 0, gamma, h), 1 + std::exp(-gamma * h), 0, 1e-14));
    }
}

// Seen from the terminal velocity the path only dies down, from a way `off` one step before now.
PROPERTY("under a strong drag, too, it lands on the exact path, however long the step") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double x = draw.real(-5, 5), off = draw.sign() * draw.real(0.5, 5);
        const double a = draw.sign() * draw.real(1, 20);
        const double gamma = draw.log(1, 100), h = draw.log(1e-2, 10), kept = std::exp(-gamma * h);
        const double way = h * a / gamma;
        const double next = learner(x - way + off, x + off * kept, a, gamma, h);
        REQUIRE(close(next, x + way + off * kept * kept, 0, 1e-13 * (10 + std::fabs(way))));
    }
}

// Where gamma h is small, 1 - exp(-gamma h) loses digits: the force is then so weak that this is
// roundoff beside the position.
PROPERTY("it is right wherever the task allows: at rest, for any drag or none, any force or none") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double length = draw.log(1e-9, 1e6);
        const double gamma = i % 4 == 0 ? 0 : draw.any_of(0.01, 1e3, {0.01});
        const double h = gamma > 0 ? draw.log(1e-6, 1e4) / gamma : draw.log(1e-6, 1e3);
        const double now = length * draw.sign() * draw.real(1, 5);
        const double before = now - length * draw.any_of(-5, 5, {0});
        const double a = length / h * (gamma > 0 ? gamma : 1 / h) * draw.any_of(-9, 9, {0});
        REQUIRE(std::isfinite(learner(before, now, a, gamma, h)));
    }
}

PROPERTY("no drag is too strong for it, and no step too long") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double length = draw.spread(1e-12, 1e12, i, 19), gamma = draw.spread(0.01, 1e12, i, 20);
        const double h = draw.spread(1e-6, 1e12, i, 21) / gamma;
        const double now = length * draw.sign() * draw.real(1, 5), before = now - length * draw.any_of(-5, 5, {0});
        const double a = length / h * gamma * draw.any_of(-9, 9, {0});
        REQUIRE(std::isfinite(learner(before, now, a, gamma, h)));
        const double step = draw.spread(1e-12, 1e12, i, 21), force = length / step / step * draw.real(-9, 9);
        REQUIRE(std::isfinite(learner(before, now, force, 0, step)));
    }
}
