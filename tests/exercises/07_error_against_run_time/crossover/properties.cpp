#include "crossover.hpp"

#include "property.hpp"

EXERCISE(crossover);

namespace {

using Run = std::array<double, 2>;

// The run of the same method that is off by `error`: a run that takes f times as long has an error
// f^order times smaller.
Run at_error(const Run& run, int order, double error) {
    return {run[0] * std::pow(run[1] / error, 1.0 / order), error};
}

struct Contest {
    explicit Contest(Draw& draw)
        : a{draw.log(1e-9, 1e3), draw.log(1e-12, 1)},
          p(draw.integer(1, 3)),
          b{draw.log(1e-9, 1e3), draw.log(1e-12, 1)},
          q(draw.integer(p + 1, 4)) {}

    Run crossing() const { return learner(a, p, b, q); }

    Run a;
    int p;
    Run b;
    int q;
};

bool same(const Run& one, const Run& other, double relative) {
    return close(one[0], other[0], relative) && close(one[1], other[1], relative);
}

// With orders three and four the error goes with the twelfth power of the seconds and the fourth of
// an error: some hundred roundoffs, and as many again if it is found by logarithms of up to 450.
constexpr double roundoff = 1e-10;

}  // namespace

PROPERTY("where both runs took the same time for the same error, there the lines cross") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Contest contest(draw);
        REQUIRE(same(learner(contest.a, contest.p, contest.a, contest.q), contest.a, roundoff));
    }
}

PROPERTY("for the error you return, both methods need the time you return") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const Contest contest(draw);
        const auto [seconds, error] = contest.crossing();
        REQUIRE(seconds > 0);
        REQUIRE(error > 0);
        REQUIRE(close(at_error(contest.a, contest.p, error)[0], seconds, roundoff));
        REQUIRE(close(at_error(contest.b, contest.q, error)[0], seconds, roundoff));
    }
}

PROPERTY("for a smaller error the method of higher order is faster, for a larger one the other") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Contest contest(draw);
        const double error = contest.crossing()[1], much = draw.log(1.1, 100);
        const auto a_is_faster = [&](double wanted) {
            return at_error(contest.a, contest.p, wanted)[0] < at_error(contest.b, contest.q, wanted)[0];
        };
        REQUIRE(!a_is_faster(error / much));
        REQUIRE(a_is_faster(error * much));
    }
}

PROPERTY("it is right wherever the task allows: the least and the largest times and errors, runs nearly alike") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 400; ++i) {
        const int p = draw.integer(1, 3), q = draw.integer(p + 1, 4);
        const Run a{draw.log(1e-12, 1e6), draw.log(1e-15, 100)};
        Run b{draw.log(1e-12, 1e6), draw.log(1e-15, 100)};
        for (double* const number : {&b[0], &b[1]})  // nearly those of A, or the same
            if (i % 4 == 0) *number = a[number == &b[1]] * (i % 8 == 0 ? 1 : 1 + draw.sign() * draw.log(1e-12, 1e-2));
        if (i % 4 == 1) b[i % 8 == 1] = a[i % 8 == 1];  // one of them the same, not the other
        // Not so far that the error, or how often one has to halve to find it, is beyond a double.
        const double far = std::log(a[0] / b[0]) + std::log(a[1]) / p - std::log(b[1]) / q;
        if (std::fabs(far) / (1.0 / p - 1.0 / q) > 440) continue;
        const auto [seconds, error] = learner(a, p, b, q);
        all &= (seconds > 0 && error > 0);
        all &= close(at_error(a, p, error)[0], at_error(b, q, error)[0], roundoff);
    }
    REQUIRE(all);
}

PROPERTY("no time and no error that the task allows is too small or too large for it, with any two orders") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 360; ++i) {
        const int p = 1 + i % 3, q = draw.integer(p + 1, 4);
        const Run a{draw.spread(1e-12, 1e6, i, 17), draw.spread(1e-15, 100, i, 19)};
        const Run b{a[0] * draw.log(1e-3, 1e3), a[1] * draw.log(1e-3, 1e3)};
        const Run in{std::clamp(b[0], 1e-12, 1e6), std::clamp(b[1], 1e-15, 100.0)};
        const auto [seconds, error] = learner(a, p, in, q);
        all &= (seconds > 0 && error > 0);
        all &= close(at_error(a, p, error)[0], at_error(in, q, error)[0], roundoff);
    }
    REQUIRE(all);
}
