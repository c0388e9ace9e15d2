// Taylor series: polynomials that follow a sine, the longer the further.

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/taylor.hpp>

#include "derivatives.hpp"
#include "functions.hpp"

using namespace timestep;

namespace {

// sin and its derivatives at 0: 0, 1, 0, −1, 0, 1, …
const std::array<double, 10> sine_at_0{0, 1, 0, -1, 0, 1, 0, -1, 0, 1};

double truncated_sine(int order, double t) { return taylor(std::span(sine_at_0).first(order + 1), t); }

// After the term in tⁿ the next one is tⁿ⁺²/(n + 2)!, then comes −tⁿ⁺⁴/(n + 4)!. So the local order
// of the remainder is n + 2 − 2t²/((n + 3)(n + 4)); up to `high` that last part stays below 0.04,
// and below 0.02 on average. From t = 0.25 on rounding, less than 1e-16, is below 2 % of the
// smallest remainder, that of n = 9: 0.25¹¹/11! = 6e-15.
double remainder_order(int n) {
    const double low = 0.25, high = std::sqrt(0.02 * (n + 3) * (n + 4));
    std::vector<double> steps, errors;
    for (int i = 0; i <= 24; ++i) {
        const double t = low * std::pow(high / low, i / 24.0);
        steps.push_back(t);
        errors.push_back(std::fabs(truncated_sine(n, t) - std::sin(t)));
    }
    return measured_order(steps, errors);
}

// The second difference of a sine at 1. Its error is h²/12 sin t − h⁴/360 sin t + …, so the local
// order is 2 less h²/15: up to a step of 1/2 that is below 0.02. Rounding, 4e-16/h², is below a
// millionth of it from 1/50 on.
double second_difference_order() {
    const double t = 1;
    std::vector<double> steps, errors;
    for (double h = 0.5; h > 0.02; h /= 1.2) {
        const double x0 = std::sin(t - h), x1 = std::sin(t), x2 = std::sin(t + h);
        steps.push_back(h);
        errors.push_back(std::fabs((x2 - 2 * x1 + x0) / (h * h) + std::sin(t)));
    }
    return measured_order(steps, errors);
}

}  // namespace

void taylor_series(lab::Findings& out) {
    out.section("A sine from its Taylor series at 0");
    std::printf("  up to   error at t = 1   order of the error\n");
    bool orders_match = true;
    double before = 1;
    bool better_and_better = true;
    for (const int n : {1, 3, 5, 7, 9}) {
        const double error = std::fabs(truncated_sine(n, 1) - std::sin(1.0));
        const double order = remainder_order(n);
        std::printf("     t^%d   %14.2g   %18.3f\n", n, error, order);
        const std::string name = "series_" + std::to_string(n);
        if (n == 1 || n == 9) out.number(name + "_error", error, "", "error of the truncated series at t = 1", 2);
        if (n == 3) out.number(name + "_order", order, "", "measured order of its error", 4);
        orders_match = orders_match && std::fabs(order - (n + 2)) <= 0.05;
        better_and_better = better_and_better && error < before;
        before = error;
    }
    out.check("series_orders", orders_match,
              "cut off after t^1, 3, 5, 7, 9 the error has order 3, 5, 7, 9, 11 to within 0.05");
    out.check("series_better", better_and_better, "each further term makes the error at t = 1 smaller");

    const double second = second_difference_order();
    std::printf("second difference of sin at 1: order %.3f\n", second);
    out.check("order_second", std::fabs(second - 2) <= 0.05, "the second difference has order 2 to within 0.05");

    auto& table = out.table("taylor.tsv", {"t", "sin", "1", "3", "5", "7", "9"});
    for (int i = -160; i <= 160; ++i) {
        const double t = i * 2 * std::numbers::pi / 160;
        table.row({t, std::sin(t), truncated_sine(1, t), truncated_sine(3, t), truncated_sine(5, t),
                   truncated_sine(7, t), truncated_sine(9, t)});
    }
}
