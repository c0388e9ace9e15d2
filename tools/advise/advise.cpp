// What every method makes of springs.

#include "advise.hpp"

#include <algorithm>
#include <cmath>

#include <timestep/checks.hpp>

#include "method_on_spring.hpp"
#include "verdict.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

namespace {

Reason judge(const MethodOnSpring& method, const SpringScene& scene, double h, const Growth& growth,
             const std::vector<StepMatrix<double>>& steps) {
    const double omega = scene.fastest.omega;
    const bool sweep = scene.several && method.new_damping && scene.fastest.zeta > 0;
    const Reason constant = sweep ? several_dampers(scene, h, method.at_once, method.least_limit)
                                  : constant_step(scene, h, method.limit, method.least_limit);
    if (scene.only_pulls) {
        const Reason taut = tether(constant, method.implicit_euler && !scene.turns);
        const bool surely_grows = taut.verdict == Verdict::grows && !scene.varying();
        if (taut.verdict == Verdict::stable || surely_grows || !scene.varying()) return taut;
        return {Verdict::not_proven, taut.reason};
    }
    if (!scene.varying()) return constant;
    Reason said = varying_steps(method.steps_commute, method.limit, omega * scene.shortest_frame,
                                omega * scene.longest_frame, steps, growth);
    // Of the slower oscillations that the fastest one may be nothing more is known.
    if (scene.bounded() && said.verdict == Verdict::grows) said.verdict = Verdict::not_proven;
    // One ellipse holds one oscillation.
    if ((scene.bounded() || scene.several) && !method.steps_commute && said.verdict == Verdict::stable &&
        std::isfinite(method.limit.value))
        return {Verdict::not_proven, "proven for the fastest oscillation alone"};
    return said;
}

}  // namespace

Advice at_step(const MethodOnSpring& method, const SpringScene& scene, double h, double wanted) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const DampedSpring<double>& spring = scene.fastest;
    if (!method.takes_damping && spring.zeta > 0)
        return {
            method.name, Verdict::refused, "takes forces of the position only", nan, nan, nan, nan, nan, nan, nan, nan,
            nan};

    const double s = spring.omega * h, zeta = spring.zeta;
    const auto all = method.multipliers(s);
    const Complex lambda = all.front(), exact = exact_rate(zeta);
    long double largest = 0;
    for (const Complex& each : all) largest = std::max(largest, std::abs(each));

    Advice advice;
    advice.method = method.name;
    advice.longest_step = method.limit.value / spring.omega;
    advice.position_error = method.position_error(s);
    advice.rate_error = rate_error(all, zeta, s);
    long double growth_per_step = std::log(largest);
    double mean_step = h;
    Growth growth{0, 0};
    std::vector<StepMatrix<double>> steps;
    if (scene.varying()) {
        const double shortest = spring.omega * scene.shortest_frame, longest = spring.omega * scene.longest_frame;
        steps = steps_of(method.matrix, shortest, longest);
        growth = method.steps_commute ? mean_growth(steps, zeta) : random_products(steps);
        growth_per_step = growth.mean;
        mean_step = (scene.shortest_frame + scene.longest_frame) / 2;
        advice.position_error = random_position_error(method.matrix, method.position_error,
                                                      DampedSpring<long double>(1, zeta), shortest, longest);
    }
    const Reason said = judge(method, scene, h, growth, steps);
    advice.verdict = said.verdict;
    advice.reason = said.reason;
    // What a tether does when it is slack, and what is not known of the springs, is not the
    // oscillation's affair.
    const bool taut = scene.only_pulls && advice.verdict == Verdict::not_proven;
    if (advice.verdict == Verdict::stable || taut) {
        const long double most = ringing(all, zeta, s);
        advice.ringing = static_cast<double>(most);
        if (most < 0 && advice.verdict == Verdict::stable) {
            const std::string why = ringing_words(all, most, zeta);
            advice.reason = std::isfinite(method.limit.value) ? why + "; " + advice.reason : why;
        }
    }
    advice.growth_per_step = static_cast<double>(std::exp(growth_per_step));
    advice.growth_per_second = static_cast<double>(std::exp(growth_per_step / mean_step));
    const long double energy_rate = 2 * (growth_per_step / mean_step - exact.real() * spring.omega);
    advice.energy_ratio = static_cast<double>(std::exp(energy_rate));
    advice.energy_drift = static_cast<double>(std::expm1(energy_rate));
    advice.period_error =
        exact.imag() > 0 && lambda.imag() > 0 ? static_cast<double>(exact.imag() * s / std::arg(lambda) - 1) : nan;
    advice.cost = method.work / mean_step;
    advice.step = h;
    if (scene.kicks && method.two_steps) advice.reason += "; restart it after each kick, or 1 m/s becomes 1.5";
    advice.right =
        (advice.verdict == Verdict::stable || taut) && advice.ringing == 0 && advice.position_error <= wanted;
    return advice;
}

Advice advise(const MethodOnSpring& method, const SpringScene& scene, double h, double wanted) {
    const DampedSpring<double>& spring = scene.fastest;
    Advice advice = at_step(method, scene, h, wanted);
    if (scene.varying() || advice.verdict == Verdict::refused) return advice;
    if (const StepRange stretch = first_right(method, spring.zeta, wanted); stretch.to > 0) {
        advice.accurate_from = stretch.from / spring.omega;
        advice.accurate_step = stretch.to / spring.omega;
        advice.accurate_cost = method.work / advice.accurate_step;
    }
    return advice;
}

bool lingers(const Advice& advice) { return advice.energy_ratio > 4 && advice.growth_per_second >= 0.01; }

std::string told_verdict(const Advice& advice) {
    if (advice.verdict != Verdict::stable) return words(advice.verdict);
    if (advice.ringing < 0) return "stable, rings";
    if (advice.position_error > 0.5) return "stable, far off";
    return lingers(advice) ? "stable, lingers" : "stable";
}

std::vector<Advice> advise(SpringScene scene, double h, double wanted) {
    const double omega = scene.fastest.omega;
    positive("omega", omega);
    positive("step", h);
    if (!std::isfinite(omega * h)) refuse("step", h, "so short that omega times it is finite");
    const double shortest = scene.varying() ? scene.shortest_frame : h;
    if (omega * shortest < 1e-12) refuse("step", shortest, "so long that omega times it is 1e-12 or more");
    if (!(wanted >= 1e-8 && wanted <= 0.5)) refuse("accuracy", wanted, "from 1e-8 to 0.5");
    scene.thrown = thrown_counts(scene.fastest.zeta, omega * h);
    std::vector<Advice> all;
    for (const MethodOnSpring& method :
         methods_on_spring(scene.fastest.zeta, scene.least.zeta, scene.several, scene.thrown))
        all.push_back(advise(method, scene, h, wanted));
    return all;
}

double best_step(const Advice& advice, double longest) {
    const double best = advice.accurate_from <= longest ? std::min(advice.accurate_step, longest) : 0;
    return advice.right && advice.step <= longest ? std::max(best, advice.step) : best;
}

double best_cost(const Advice& advice, double longest) {
    const double step = best_step(advice, longest);
    return step > 0 ? advice.cost * (advice.step / step) : 0;
}

const Advice* cheapest(const std::vector<Advice>& all, double longest) {
    const Advice* best = nullptr;
    for (const Advice& advice : all) {
        if (!(best_step(advice, longest) > 0)) continue;
        const double ratio = best ? best_cost(advice, longest) / best_cost(*best, longest) : 0;
        const bool alike = std::abs(ratio - 1) < 1e-9;
        if (alike ? advice.position_error < best->position_error : ratio < 1) best = &advice;
    }
    return best;
}

}  // namespace timestep
