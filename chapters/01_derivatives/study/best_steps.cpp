// Where smaller steps stop helping: the error falls with h, meets the rounding of the values, and
// rises again.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <timestep/difference_error.hpp>
#include <timestep/differences.hpp>

#include "derivatives.hpp"
#include "functions.hpp"

using namespace timestep;

namespace {

// Errors are the largest over a thousand neighbours of x, from x to x + 0.01: at a single x the
// rounding may happen to cancel.
constexpr double reach = 0.01;
constexpr int neighbours = 1000;

// Negative when the step is too small to move x.
template <class Real, class Formula, class Function>
double largest_error(const Formula& formula, const Function& f, double x, double h) {
    double largest = 0;
    for (int i = 0; i < neighbours; ++i) {
        const Real at = static_cast<Real>(x + i * reach / neighbours);
        const Real step = step_taken(at, static_cast<Real>(h));
        if (step == 0) return -1;
        const long double slope = formula(f, at, step);
        const long double exact = f.derivative(1, static_cast<long double>(at));
        largest = std::max(largest, static_cast<double>(std::fabs(slope - exact)));
    }
    return largest;
}

// The larger of |f⁽ᵏ⁾| at the two ends of the neighbourhood.
template <class Function>
double size(const Function& f, int k, double x) {
    return std::max(std::fabs(f.derivative(k, x)), std::fabs(f.derivative(k, x + reach)));
}

// What the values of f near x are off by: half their last digit, at most.
template <class Real, class Function>
double rounding(const Function& f, double x) {
    return std::numeric_limits<Real>::epsilon() / 2.0 * size(f, 0, x);
}

struct Best {
    double step = 0, error = std::numeric_limits<double>::infinity();
};

// Measures and predicts the error at every step; returns the best one measured.
template <class Real, class Formula, class Function>
Best scan(const Formula& formula, const Function& f, double x, lab::Table& table) {
    const double noise = rounding<Real>(f, x);
    const double slope = size(f, formula.order + 1, x);
    Best best;
    for (int quarter = 0;; ++quarter) {
        const double h = std::exp2(-quarter / 4.0);
        const double error = largest_error<Real>(formula, f, x, h);
        if (error < 0) return best;
        table.row({h, error, error_bound(formula, h, noise, slope)});
        if (error < best.error) best = {h, error};
    }
}

// One formula in one number type: the best step, and whether the predicted one is as good.
//
// Half a last digit lies between ε|f|/4 and ε|f|/2; x³ is rounded twice, and a thousand neighbours
// come within a fifth of the worst case. So the noise is 0.4 to 2 times the ε|f|/2 that we predict
// with. If it is κ times as large, the forward difference at the predicted step errs
// (1 + κ)/(2√κ) ≤ 1.11 times the least possible, the others less; neighbouring steps that the scan
// offers, a factor 2^(1/8) away at most, and the scatter of the largest error, a tenth, leave it
// below 1.3. The best step goes with √κ at most, a factor 1.6, and the minimum is so flat (4 % on
// 1.3 to either side) that the scatter may move it by 1.3: a factor 2 in all.
template <class Real, class Formula, class Function>
Best measure(const Formula& formula, const Function& f, double x, const std::string& type, bool& as_predicted,
             lab::Table& costs, lab::Findings& out) {
    std::string name = formula.name;
    std::replace(name.begin(), name.end(), '-', '_');
    name += "_" + type;
    auto& table = out.table(name + ".tsv", {"h", "error", "predicted"});
    const Best best = scan<Real>(formula, f, x, table);

    const double noise = rounding<Real>(f, x);
    const double slope = size(f, formula.order + 1, x);
    const double predicted = best_step(formula, noise, slope);
    const auto cell = [](double value) {
        char text[32];
        std::snprintf(text, sizeof text, std::isfinite(value) ? "%.2g" : "any", value);
        return std::string(text);
    };
    std::printf("  %-11s %-7s %12.2g %12s %12.2g\n", formula.name, type.c_str(), best.step, cell(predicted).c_str(),
                best.error);
    out.number("best_error_" + name, best.error, "", "error at that step", 2);
    if (!std::isfinite(predicted)) return best;  // nothing is left out, so no step is too large
    costs.row({formula.name + (", " + type), double(formula.evaluations), cell(best.step), cell(predicted),
               cell(best.error)});
    as_predicted = as_predicted && best.step < 2 * predicted && predicted < 2 * best.step &&
                   largest_error<Real>(formula, f, x, predicted) < 1.3 * best.error;
    return best;
}

template <class Function>
void all(const Function& f, double x, lab::Findings& out) {
    auto& costs = out.table("costs.tsv", {"formula", "values", "best h tried", "predicted", "error there"});
    std::printf("  %-11s %-7s %12s %12s %12s\n", "", "", "best h", "predicted", "error there");
    bool as_predicted = true, float_errs_more = true, order_helps = true;
    Best lower[2] = {{0}, {0}};  // of the formula of lower order, in float and in double
    const auto both = [&](const auto& formula) {
        const Best now[2] = {measure<float>(formula, f, x, "float", as_predicted, costs, out),
                             measure<double>(formula, f, x, "double", as_predicted, costs, out)};
        float_errs_more = float_errs_more && now[0].step > now[1].step && now[0].error > now[1].error;
        for (int i = 0; i < 2; ++i) {
            order_helps = order_helps && now[i].step > lower[i].step && now[i].error < lower[i].error;
            lower[i] = now[i];
        }
    };
    both(forward_difference);
    both(central_difference);
    both(five_point_difference);
    out.number("neighbours", neighbours, "", "places at which an error is measured");
    out.number("reach", reach, "", "they lie between x and x + this");
    out.number("epsilon_float", std::numeric_limits<float>::epsilon(), "", "from 1 to the next float", 2);
    out.number("epsilon_double", std::numeric_limits<double>::epsilon(), "", "from 1 to the next double", 2);
    out.check("float_errs_more", float_errs_more,
              "in float every formula has a larger optimal step size and a larger error than in double");
    out.check("order_helps", order_helps,
              "the higher the order, the larger the optimal step size and the smaller the error there");
    out.check("best_steps", as_predicted,
              "every predicted step is within a factor 2 of the best one measured, and its error "
              "within 1.3");

    const double best = best_step(forward_difference, rounding<double>(f, x), size(f, 2, x));
    const double tiny = best / 1000;
    out.check("rises_again",
              largest_error<double>(forward_difference, f, x, tiny) >
                  100 * largest_error<double>(forward_difference, f, x, best),
              "a thousand times below its optimal step size the forward difference errs over 100 "
              "times more");
}

}  // namespace

void best_steps(const Settings& settings, lab::Findings& out) {
    char title[60];
    std::snprintf(title, sizeof title, "The best h for %s at x = %g", settings.function.c_str(), settings.at);
    out.section(title);
    with_function(settings.function, [&](const auto& f) { all(f, settings.at, out); });
}
