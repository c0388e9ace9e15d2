#include "step_for_error.hpp"

#include "property.hpp"

EXERCISE(step_for_error);

namespace {

double draw_error(Draw& draw) { return draw.log(1e-12, 1e3); }

double draw_h(Draw& draw) { return draw.log(1e-6, 10); }

// How far off a run of one second is, of v' = -v from v = 1. A step multiplies by the series of
// exp(-h) up to the order. The last step may be a part of one.
double error_of_run(double h, int order) {
    double factor = 1, term = 1;
    for (int k = 1; k <= order; ++k) factor += term *= -h / k;
    return std::fabs(std::pow(factor, 1 / h) - std::exp(-1));
}

}  // namespace

PROPERTY("a run that is off by just what is wanted keeps its step") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const double error = draw_error(draw), h = draw_h(draw);
        REQUIRE(close(learner(error, h, draw.integer(1, 4), error), h, 1e-12));
    }
}

PROPERTY("half the step is off by 2^order times less, and twice the step by 2^order times more") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double error = draw.log(1e-10, 1e1), h = draw.log(1e-5, 5);
        const int order = draw.integer(1, 4);
        REQUIRE(close(learner(error, h, order, std::ldexp(error, -order)), h / 2, 1e-12));
        REQUIRE(close(learner(error, h, order, std::ldexp(error, order)), 2 * h, 1e-12));
    }
}

// The fourth power of a step makes four times its roundoff, and a root takes it back.
PROPERTY("where the error is C h^order, a run with your step is off by what is wanted") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const double error = draw_error(draw), h = draw_h(draw), wanted = draw_error(draw);
        const int order = draw.integer(1, 4);
        const double step = learner(error, h, order, wanted);
        REQUIRE(close(error * std::pow(step / h, order), wanted, 1e-11));
    }
}

// C changes with the step by about the step, which is 0.06 at most.
PROPERTY("a fall against the wind, run for real, is off by nearly what is wanted") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const int order = draw.integer(1, 4);
        const double h = draw.log(0.005, 0.02), error = error_of_run(h, order);
        const double wanted = error * draw.log(0.3, 3);
        REQUIRE(close(error_of_run(learner(error, h, order, wanted), order), wanted, 0.1));
    }
}

PROPERTY("it is right wherever the task allows: any two errors, far apart or nearly the same, any step") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 400; ++i) {
        const double error = draw.any_of(1e-12, 1e3, {1e-12, 1, 1e3}), h = draw.any_of(1e-6, 10, {1e-6, 10});
        const double near = error * (1 + draw.sign() * draw.log(1e-12, 1e-2));
        const double wanted = i % 2 == 0 ? near : draw.any_of(1e-12, 1e3, {1e-12, 1, 1e3});
        const int order = draw.integer(1, 4);
        all &= close(error * std::pow(learner(error, h, order, wanted) / h, order), wanted, 1e-11);
    }
    REQUIRE(all);
}

PROPERTY("no error and no step that the task allows is too small or too large for it, with any order") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 240; ++i) {
        const double error = draw.spread(1e-12, 1e3, i, 15), wanted = draw.spread(1e-12, 1e3, i, 16);
        const double h = draw.spread(1e-6, 10, i, 7);
        const int order = 1 + i % 4;
        all &= close(error * std::pow(learner(error, h, order, wanted) / h, order), wanted, 1e-11);
    }
    REQUIRE(all);
}
