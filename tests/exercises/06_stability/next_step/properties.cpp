#include "next_step.hpp"

#include "property.hpp"

EXERCISE(next_step);

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double draw_h(Draw& draw) { return draw.log(1e-9, 1e6); }

double draw_tolerance(Draw& draw) { return draw.log(1e-12, 1e6); }

// A motion that ends at `end`, and a step of it is off by C h^(order + 1). C is such that the two
// halves of a step of `right` are off by the tolerance.
struct Motion {
    Motion(Draw& draw, double right)
        : order(draw.integer(1, 8)),
          tolerance(draw_tolerance(draw)),
          sign(draw.sign()),
          end(draw.real(-3, 3) * tolerance),
          right(right) {}

    // What a whole step of h is off by: 2^order times the halves.
    double off(double h) const { return sign * tolerance * std::pow(h / right, order + 1); }
    double whole(double h) const { return end + std::exp2(order) * off(h); }
    double halves(double h) const { return end + off(h); }
    double next(double h) const { return learner(whole(h), halves(h), h, tolerance, order); }

    int order;
    double tolerance, sign, end, right;
};

}  // namespace

PROPERTY("results that agree to the last bit let the step grow to five times its length") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double same = draw.real(-10, 10), h = draw_h(draw);
        const double next = learner(same, same, h, draw_tolerance(draw), draw.integer(1, 8));
        REQUIRE(close(next, 5 * h, 1e-12));
    }
}

PROPERTY("results that are not finite make the step a fifth of its length") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double x = draw.real(-10, 10), h = draw_h(draw), tolerance = draw_tolerance(draw);
        const int order = draw.integer(1, 8);
        const double far = draw.sign() * infinity, none = not_a_number;
        const std::array<double, 2> results[] = {{none, x}, {x, none},  {none, none}, {far, x},
                                                 {x, far},  {far, far}, {far, -far},  {far, none}};
        for (const auto& [whole, halves] : results)
            REQUIRE(close(learner(whole, halves, h, tolerance, order), h / 5, 1e-12));
    }
}

PROPERTY("the next step is at most five times as long, and a fifth at least, whatever the error") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double h = draw_h(draw), tolerance = draw_tolerance(draw);
        const int order = draw.integer(1, 8);
        // A fifth or five times would need an error 5^9 times as large or small, at most.
        const double much = draw.sign() * tolerance * draw.log(1e10, 1e30);
        REQUIRE(close(learner(much, 0, h, tolerance, order), h / 5, 1e-12));
        REQUIRE(close(learner(much, -much, h, tolerance, order), h / 5, 1e-12));
        const double little = draw.sign() * tolerance * draw.log(1e-30, 1e-10);
        REQUIRE(close(learner(0, little, h, tolerance, order), 5 * h, 1e-12));
        REQUIRE(close(learner(little, -little, h, tolerance, order), 5 * h, 1e-12));
        const double any = learner(tolerance * draw.log(1e-10, 1e10), 0, h, tolerance, order);
        REQUIRE(any >= h / 5 * (1 - 1e-12));
        REQUIRE(any <= 5 * h * (1 + 1e-12));
    }
}

// The results are sums with an end of three tolerances at most, and what they are off by is
// (1/4)^9 of that at the least: it is known to 1e-10.
PROPERTY("within the limits the next step is 0.9 times the one that is off by the tolerance") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double h = draw_h(draw);
        const Motion motion(draw, h * draw.log(0.23, 5.5));
        const double next = motion.next(h);
        REQUIRE(close(std::fabs(motion.off(next / 0.9)), motion.tolerance, 1e-8));
    }
}

PROPERTY("it is right wherever the task allows: results of any size, far apart or nearly equal, any tolerance") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 600; ++i) {
        const double h = draw.any_of(1e-9, 1e6, {1e-9, 1, 1e6}), gap = draw.log(1e-15, 10);
        const double halves = i % 5 == 4 ? 0 : draw.sign() * draw.log(1e-12, 1e12);
        const double whole = halves == 0 ? draw.sign() * gap : halves * (1 + draw.sign() * gap);
        const int order = draw.integer(1, 8);
        // Mostly one with which the factor is between the limits, or just beside one of them.
        const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
        const double beside = i % 3 == 0 ? 0.2 : i % 3 == 1 ? 5 : draw.log(0.1, 10);
        const double factor = beside * (1 + draw.sign() * draw.log(1e-6, 1e-1)) / 0.9;
        double tolerance = error * std::pow(factor, order + 1);
        if (i % 7 == 6 || tolerance < 1e-12 || tolerance > 1e6) tolerance = draw_tolerance(draw);
        const double next = learner(whole, halves, h, tolerance, order);
        all &= (next >= h / 5 * (1 - 1e-12) && next <= 5 * h * (1 + 1e-12));
    }
    REQUIRE(all);
}

// Numbers of which the difference is infinite among them: that error is larger than any.
PROPERTY("no results are too small or too large for it, as long as they are numbers") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 420; ++i) {
        const double halves = draw.sign() * draw.spread(1e-300, 1.7e308, i, 21), gap = draw.log(1e-12, 1);
        const double whole = i % 4 == 0 ? -halves : halves * (1 - gap), h = draw.spread(1e-9, 1e6, i, 20);
        const double next = learner(whole, halves, h, draw_tolerance(draw), draw.integer(1, 8));
        all &= (next >= h / 5 * (1 - 1e-12) && next <= 5 * h * (1 + 1e-12));
        if (i % 3 == 0)
            all &= close(learner(halves, halves, h, draw_tolerance(draw), draw.integer(1, 8)), 5 * h, 1e-12);
        const double far = std::fabs(whole - halves);
        if (far > 1e20) all &= close(next, h / 5, 1e-12);
        if (far < 1e-25) all &= close(next, 5 * h, 1e-12);
    }
    REQUIRE(all);
}
