#include "best_acceleration_step.hpp"

#include "property.hpp"

// As near as comparing sums finds it: the bound is flat at its bottom, and a step that is off by 2e-8 changes it by
// less than roundoff.
EXERCISE_WITHIN(best_acceleration_step, 5e-8);

PROPERTY("a step is a time: with positions in another unit of length it stays the same") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double noise = draw.log(1e-6, 1e-2), snap = draw.log(1, 1e4);
        const double unit = draw.log(1e-2, 1e2);
        REQUIRE(close(learner(unit * noise, unit * snap), learner(noise, snap), 1e-7));
    }
}

PROPERTY("a step is a time: with another unit of time it changes by that unit") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double noise = draw.log(1e-6, 1e-2), snap = draw.log(1, 1e4), unit = draw.log(0.3, 3);
        const double slower = learner(noise, snap / (unit * unit * unit * unit));
        REQUIRE(close(slower, unit * learner(noise, snap), 1e-7));
    }
}

PROPERTY("more noise asks for a longer step, more snap for a shorter one") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double noise = draw.log(1e-6, 1e-2), snap = draw.log(1, 1e4);
        const double more = draw.real(1.1, 10);
        const double h = learner(noise, snap);
        REQUIRE(h > 0);
        REQUIRE(learner(more * noise, snap) > h);
        REQUIRE(learner(noise, more * snap) < h);
    }
}

// The bound is flat at its bottom: a step off by a part in ten thousand costs 2e-8 of it.
PROPERTY("a step that is slightly longer or shorter than yours has a larger worst error") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double noise = draw.log(1e-6, 1e-2), snap = draw.log(1, 1e4);
        const auto worst = [&](double h) { return snap * h * h / 12 + 4 * noise / (h * h); };
        const double h = learner(noise, snap);
        REQUIRE(worst(h) < worst(1.0001 * h));
        REQUIRE(worst(h) < worst(h / 1.0001));
    }
}

// At the least of a sum of h² and 1/h² the two parts are equal: off by 4e-7 for a step that is off
// by 1e-7, as one is that is found by comparing sums.
PROPERTY("the optimal step size is found for the finest tracker and the coarsest, for any motion") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double noise = draw.log(1e-15, 1e9), snap = draw.log(1e-12, 1e15);
        const double h = learner(noise, snap);
        REQUIRE(h > 0);
        REQUIRE(close(snap * h * h / 12, 4 * noise / (h * h), 1e-6));
    }
}

PROPERTY("no noise and no snap is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 240; ++i) {
        const double noise = draw.spread(1e-15, 1e15, i, 15), snap = draw.spread(1e-15, 1e15, i, 16);
        REQUIRE(learner(noise, snap) > 0);
    }
}
