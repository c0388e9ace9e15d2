// How fast the error falls as h shrinks: the order of each formula, measured where its leading
// error term rules.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include <timestep/differences.hpp>
#include <timestep/measured_order.hpp>

#include "derivatives.hpp"
#include "functions.hpp"

using namespace timestep;

namespace {

// Given the polynomial tⁿ/n! a formula answers with the factor of hⁿ⁻¹ f⁽ⁿ⁾ in its Taylor series: 1
// for n = 1, that is the slope itself, and the error terms after it.
template <class Formula>
double taylor_factor(const Formula& formula, int n) {
    return formula([n](double t) { return std::pow(t, n) / std::tgamma(n + 1); }, 0.0, 1.0);
}

// The order that the Taylor series promises at x, and the steps at which it can be seen.
struct Promise {
    int order = 0;  // 0: no error term at all
    double low = 0, high = 0;
    bool visible() const { return order > 0 && high > 4 * low; }
};

// With E = C hᵖ (1 + r hᵐ) the local order is p + m r hᵐ: `high` keeps the second part below 0.02.
// Rounding gives E an error of up to noise_gain · noise/h: `low` keeps that below 1 % of C hᵖ,
// which turns a line fitted over more than a factor 4 by less than 0.01 · 2/ln 4 < 0.02. Together
// the measured order is right to 0.04.
template <class Formula, class Function>
Promise promise(const Formula& formula, const Function& f, double x) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    Promise result;
    double leading = 0;
    for (int n = 2; n <= 12; ++n) {
        const double term = std::fabs(taylor_factor(formula, n) * f.derivative(n, x));
        if (term == 0) continue;
        if (leading == 0) {
            leading = term;
            result = {n - 1, 0, 0.5};
        } else {
            const int m = n - 1 - result.order;
            result.high = std::min(0.5, std::pow(0.02 * leading / (m * term), 1.0 / m));
            break;
        }
    }
    const double noise = epsilon / 2 * (std::fabs(f(x)) + result.high * std::fabs(f.derivative(1, x)));
    result.low = std::pow(100 * formula.noise_gain * noise / leading, 1.0 / (result.order + 1));
    result.low = std::max(result.low, 1e-6);  // at a root there is next to no rounding
    return result;
}

template <class Formula, class Function>
double order_at(const Formula& formula, const Function& f, double x, const Promise& promised) {
    std::vector<double> steps, errors;
    for (int i = 0; i <= 24; ++i) {
        const double wish = promised.low * std::pow(promised.high / promised.low, i / 24.0);
        const double h = step_taken(x, wish);
        steps.push_back(h);
        errors.push_back(std::fabs(formula(f, x, h) - f.derivative(1, x)));
    }
    return measured_order(steps, errors);
}

// One cell of the table. Returns whether the order is the formula's own, as far as it can be seen.
template <class Formula, class Function>
bool cell(const Formula& formula, const Function& f, double x, const std::string& name, lab::Findings& out) {
    const Promise promised = promise(formula, f, x);
    if (!promised.visible()) {
        std::printf("  %8s", promised.order == 0 ? "exact" : "hidden");
        return true;
    }
    const double order = order_at(formula, f, x, promised);
    std::printf("  %8.3f", order);
    out.number("order_" + name + "_" + f.name, order, "", "measured order on that function", 4);
    return std::fabs(order - formula.order) <= 0.05;
}

template <class Formula>
void row(const Formula& formula, const std::string& name, double x, lab::Findings& out) {
    std::printf("  %-11s", formula.name);
    const bool on_exp = cell(formula, Exponential{}, x, name, out);
    const bool on_sin = cell(formula, Sine{}, x, name, out);
    const bool on_cube = cell(formula, Cube{}, x, name, out);
    std::printf("\n");
    out.check("order_" + name, on_exp && on_sin && on_cube,
              std::string("the ") + formula.name + " difference has order " + std::to_string(formula.order) +
                  " to within 0.05 wherever its error can be seen");
}

}  // namespace

void orders(const Settings& settings, lab::Findings& out) {
    char title[60];
    std::snprintf(title, sizeof title, "Measured orders at x = %g", settings.at);
    out.section(title);
    std::printf("  %-11s  %8s  %8s  %8s\n", "", Exponential::name, Sine::name, Cube::name);
    row(forward_difference, "forward", settings.at, out);
    row(backward_difference, "backward", settings.at, out);
    row(central_difference, "central", settings.at, out);
    row(five_point_difference, "five_point", settings.at, out);

    const double flat = order_at(forward_difference, Sine{}, 0, promise(forward_difference, Sine{}, 0));
    std::printf("  forward, sin at x = 0, where the second derivative is zero: %.3f\n", flat);
    out.number("order_flat", flat, "", "order of the forward difference of sin at 0", 4);
    out.check("order_flat", std::fabs(flat - 2) <= 0.05,
              "where the second derivative vanishes the forward difference has order 2");
}
