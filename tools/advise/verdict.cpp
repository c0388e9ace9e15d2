// Will it blow up, and why.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "method_on_spring.hpp"
#include "words.hpp"

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

std::string limit_reason(const std::string& quantity, double value, const StabilityLimit& limit) {
    if (!std::isfinite(limit.value)) return phrase("why.every_step");
    const int digits = number(value) == number(limit.value) ? 7 : 4;  // as many as tell the two apart
    const std::string left = number(value, digits), right = number(limit.value, digits), words = limit.formula;
    const std::string formula = right == words || words.empty() ? ""
                                : words.starts_with("the ")     ? ", " + words
                                                                : " = " + words;
    const Values values{{"quantity", quantity}, {"value", left}, {"limit", right}, {"formula", formula}};
    return phrase(left == right ? "why.at_limit" : value < limit.value ? "why.below" : "why.above", values);
}

namespace {

// A verdict, and the formula behind it.
struct Reason {
    Verdict verdict;
    std::string reason;
};

// How fast a state grows per step: the mean of the logarithm, and how well it is known.
struct Growth {
    double mean, deviation;
};

// So many lengths stand for all those between the shortest and the longest, evenly apart.
inline constexpr int lengths = 129;

double length(double shortest, double longest, int i) { return shortest + (longest - shortest) * i / (lengths - 1); }

// The square of a state's size, x² + 2c xv + d v²: an ellipse. What does a step multiply it by at
// most?
struct Ellipse {
    double c, d;
    bool proper() const { return d > 1e-12 && c * c < 0.999999 * d; }
    double gain(const StepMatrix<double>& a) const {  // the larger root of det(Aᵀ P A − λ P) = 0
        const double p = a.xx * a.xx + 2 * c * a.xx * a.vx + d * a.vx * a.vx;
        const double q = a.xx * a.xv + c * (a.xx * a.vv + a.xv * a.vx) + d * a.vx * a.vv;
        const double r = a.xv * a.xv + 2 * c * a.xv * a.vv + d * a.vv * a.vv;
        const double det = d - c * c, half = (p * d + r - 2 * q * c) / (2 * det);
        return half + std::sqrt(std::max(0.0, half * half - a.determinant() * a.determinant()));
    }
    // Of all the steps, with what the curve may rise between two lengths added: an eighth of its
    // bend.
    double worst(const std::vector<StepMatrix<double>>& steps) const {
        double most = 0, bend = 0, before = 0, last = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const double now = gain(steps[i]);
            if (i > 1) bend = std::max(bend, std::abs(now - 2 * last + before));
            before = last, last = now, most = std::max(most, now);
        }
        return most + bend / 4;  // twice that, for good measure
    }
};

// Is there an ellipse that no step of any of the lengths leaves? Then no order of them lets
// anything grow. We go to the one whose worst gain is least by smaller and smaller moves; the first
// to have none will do.
bool common_ellipse(const std::vector<StepMatrix<double>>& steps) {
    Ellipse best{0, 1};
    double least = best.worst(steps);
    for (const double c : {-0.9, -0.5, -0.2, 0.0, 0.2, 0.5, 0.9})
        for (const double d : {0.01, 0.1, 0.4, 1.0, 2.5, 10.0, 100.0}) {
            const Ellipse other{c * std::sqrt(d), d};
            if (const double worst = other.worst(steps); worst < least) best = other, least = worst;
        }
    for (double move = 0.3; move > 1e-4 && least > 1; move /= 1.5)
        for (int way = 0; way < 4; ++way) {
            const double sign = way % 2 ? 1 : -1, root = std::sqrt(best.d);
            const double d = way < 2 ? best.d * std::exp(sign * move) : best.d;
            const Ellipse other{(best.c / root + (way < 2 ? 0 : sign * move)) * std::sqrt(d), d};
            if (!other.proper()) continue;
            if (const double worst = other.worst(steps); worst < least) best = other, least = worst;
        }
    return least <= 1;
}

// A constant step. `high` is the limit for the fastest oscillation that can be, `low` for the
// slowest that the fastest one can be. By each method's formula a slower swing with less damping is
// stable where a faster one with more, in proportion, is: no limit rises faster than ζ does.
Reason constant_step(const SpringScene& scene, double h, const StabilityLimit& high, const StabilityLimit& low) {
    const double s = scene.fastest.omega * h, least = scene.least.omega * h;
    const Verdict at_most = verdict(s, high.value), at_least = verdict(least, low.value);
    if (at_most == Verdict::stable || !scene.bounded()) return {at_most, limit_reason("ωh", s, high)};
    if (at_least == Verdict::grows)
        return {Verdict::grows, phrase("why.at_least", {{"reason", limit_reason("ωh", least, low)}})};
    return {Verdict::not_proven,
            phrase("why.between", {{"least", number(least)}, {"most", number(s)}, {"limit", number(high.value)}})};
}

// Several dampers at the new velocity, one after another there and back with a root of each
// division, or all in one system of equations. Either way v₂ = P (v₁ − h A x₁) with P symmetric, 0
// < P ≤ 1, masses as the measure. An eigenvalue λ of the step solves (1 + c) λ² − (2 + c − s) λ + 1
// = 0 with c ≥ 0 from P⁻¹ − 1 and s from h²A, both taken at its eigenvector. Up to s = 4, ωh = 2
// without the dampers, |λ| ≤ 1. Beyond it `high` and `low` are the limits of one system of
// equations.
Reason several_dampers(const SpringScene& scene, double h, const StabilityLimit& high, const StabilityLimit& low) {
    const double s = scene.fastest.omega * h, least = scene.least.omega * h;
    if (verdict(s, 2) == Verdict::stable) return {Verdict::stable, phrase("why.swept", {{"value", number(s)}})};
    if (verdict(least, low.value) == Verdict::grows)
        return {Verdict::grows, phrase("why.at_least_at_once", {{"reason", limit_reason("ωh", least, low)}})};
    return {Verdict::not_proven, phrase("why.not_swept", {{"value", number(s)}, {"limit", number(high.value)}})};
}

// A tether that lets go and takes hold between two steps can be stretched, when it takes hold, by
// more than its speed ever paid for. Implicit Euler alone has a proof: between points the force is
// the slope of a potential that is convex, slack or taut, and by each of its steps the energy
// falls. Off a centre of mass the potential is not convex in the body's angle, and a step of
// implicit Euler may gain.
Reason tether(const Reason& taut, bool implicit_euler) {
    if (implicit_euler) return {Verdict::stable, phrase("why.tether_every_step")};
    if (taut.verdict != Verdict::stable) return {taut.verdict, phrase("why.taut", {{"reason", taut.reason}})};
    return {Verdict::not_proven, phrase("why.tether_may_gain", {{"reason", taut.reason}})};
}

// The steps of all lengths, in double.
std::vector<StepMatrix<double>> steps_of(const MatrixOf& matrix, double shortest, double longest) {
    std::vector<StepMatrix<double>> all;
    for (int i = 0; i < lengths; ++i) {
        const auto a = matrix(length(shortest, longest, i));
        all.push_back({double(a.xx), double(a.xv), double(a.vx), double(a.vv)});
    }
    return all;
}

// How fast a state grows when every frame may be as long as any other: the mean of the logarithm a
// step, and how well a thousand runs of a thousand steps know it. The seed is fixed: the advice is
// the same each time. Sizes are those of the ellipse on which the step of the middle length goes
// round, if it does: x² + v² swings by itself, and where in its oscillation a run begins and ends
// would be taken for growth. For the same reason runs begin anywhere.
Growth random_products(const std::vector<StepMatrix<double>>& steps) {
    constexpr int runs = 1000, count = 1000, warm_up = 24;
    const StepMatrix<double>& middle = steps[lengths / 2];
    const double p = -middle.vx, q = (middle.xx - middle.vv) / 2, r = middle.xv;
    const bool round = p * r - q * q > 1e-9 * std::abs(p * r) && p > 0;
    const auto size_of = [&](double x, double v) {
        return round ? std::sqrt(p * x * x + 2 * q * x * v + r * v * v) : std::hypot(x, v);
    };
    std::mt19937_64 numbers(18);
    double sum = 0, squares = 0;
    for (int k = 0; k < runs; ++k) {
        const double angle = 2 * std::numbers::pi * k / runs;
        double x = std::cos(angle), v = std::sin(angle), log_size = 0;
        for (int n = -warm_up; n < count; ++n) {
            if (n == 0) {  // by now it has turned into the direction that grows
                const double size = size_of(x, v);
                x /= size, v /= size, log_size = 0;
            }
            const StepMatrix<double>& a =
                steps[(numbers() % (2 * (lengths - 1)) + 1) / 2];  // the two ends half as often
            const double next = a.xx * x + a.xv * v;
            v = a.vx * x + a.vv * v, x = next;
            if (n % 8 == 0) {
                const double size = std::abs(x) + std::abs(v);
                if (!(size > 0)) return {-INFINITY, 0};
                log_size += std::log(size), x /= size, v /= size;
            }
        }
        const double rate = (log_size + std::log(size_of(x, v))) / count;
        sum += rate, squares += rate * rate;
    }
    const double mean = sum / runs;
    return {mean, std::sqrt(std::max(0.0, squares / runs - mean * mean) / runs)};
}

// The same where all steps have the same patterns, those of the equation's own matrix F = (0, 1;
// −1, −2ζ), each multiplied by its own factor: the mean over all lengths. A step is αI + βF, and so
// are its factors α + βμ. (Which of a step's two eigenvalues is the larger changes with the length,
// so by size they cannot be told apart.)
Growth mean_growth(const std::vector<StepMatrix<double>>& steps, double zeta) {
    const Complex rate = exact_rate(zeta);
    long double most = -INFINITY;
    for (const Complex& mu : {rate, 1.0L / rate}) {  // the product of the two is 1
        long double sum = 0;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const long double weight = i == 0 || i + 1 == steps.size() ? 0.5L : 1;
            sum +=
                weight *
                std::log(std::abs(static_cast<long double>(steps[i].xx) + static_cast<long double>(steps[i].xv) * mu));
        }
        most = std::max(most, sum / (lengths - 1));
    }
    return {static_cast<double>(most), 0};
}

// So slow a growth a step is not told from none.
inline constexpr double slowest_growth = 2e-6;

// Frames between two lengths, as ωh. A Runge–Kutta step of any length is a function of one matrix,
// that of the equation. So all lengths share their patterns, and a product of steps is stable when
// each is, which is when the longest one is. Where the limit is infinite that holds for every
// length: no step raises the energy. (BDF2 begins anew when the length changes, and then is
// implicit midpoint.) Others turn the patterns with the length, and steps that are stable one by
// one may grow together: there only an ellipse that none of them leaves is a proof.
Reason varying_steps(bool steps_commute, const StabilityLimit& limit, double shortest, double longest,
                     const std::vector<StepMatrix<double>>& steps, const Growth& growth) {
    if (!std::isfinite(limit.value)) return {Verdict::stable, phrase("why.any_order")};
    const bool sure = growth.mean > slowest_growth + 5 * growth.deviation;
    if (steps_commute) {
        const Verdict at_most = verdict(longest, limit.value), at_least = verdict(shortest, limit.value);
        if (at_most == Verdict::stable)
            return {at_most, phrase("why.longest_frame", {{"reason", limit_reason("ωh", longest, limit)}})};
        if (at_least == Verdict::grows)
            return {at_least, phrase("why.shortest_frame", {{"reason", limit_reason("ωh", shortest, limit)}})};
    } else if (limit.value > longest && common_ellipse(steps)) {
        return {Verdict::stable, phrase("why.ellipse")};
    }
    if (sure) return {Verdict::grows, phrase("why.random_frames")};
    return {Verdict::not_proven, phrase(steps_commute ? "why.limit_between_frames" : "why.limit_of_constant_step",
                                        {{"limit", number(limit.value)}})};
}

// The largest distance from the true place in the first period, of thirty runs with frames at
// random; and of two with constant ones, the shortest and the longest.
double random_position_error(const MatrixOf& matrix, const std::function<double(long double)>& constant,
                             const DampedSpring<long double>& spring, double shortest, double longest) {
    double most = std::max(constant(shortest), constant(longest));
    const long double end = 2 * std::numbers::pi_v<long double> / std::abs(exact_rate(spring.zeta));
    if (end / shortest > 2000) return most;  // so many frames even out
    std::mt19937_64 numbers(18);
    std::vector<StepMatrix<long double>> steps;
    for (int i = 0; i < lengths; ++i) steps.push_back(matrix(length(shortest, longest, i)));
    for (int k = 0; k < 30; ++k) {
        long double x = 1, v = 0, t = 0;
        for (int n = 0; n < 8 || t < end; ++n) {
            const int i = static_cast<int>(numbers() % lengths);
            t += length(shortest, longest, i);
            if (t > end && n >= 1 && end / longest >= 3) break;
            const auto& a = steps[static_cast<std::size_t>(i)];
            const long double next = a.xx * x + a.xv * v;
            v = a.vx * x + a.vv * v, x = next;
            const long double off = std::abs(x - spring.exact(State<long double>{0, 1, 0}, t).x);
            most = !(off <= most) ? static_cast<double>(off) : most;
        }
    }
    return most;
}

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
        return {Verdict::not_proven, phrase("why.fastest_alone")};
    return said;
}

// Where it rings. Of two decays with multipliers of different signs the fast one is below zero.
std::string ringing_reason(const std::vector<Complex>& all, long double most, double zeta) {
    const bool one = std::any_of(all.begin(), all.end(), [](const Complex& z) { return z.real() >= 0; });
    const std::string by = number(static_cast<double>(-most), 3);
    const std::string part = phrase(zeta < 1 ? "why.motion" : one ? "why.fast_part" : "why.decaying_part");
    return phrase("why.rings", {{"part", part}, {"factor", by == "1" ? phrase("why.nearly_one") : "−" + by}});
}

}  // namespace

Advice refused(const MethodOnSpring& method) {
    Advice advice;
    advice.method = method.name, advice.verdict = Verdict::refused, advice.reason = phrase("why.refused");
    return advice;
}

void tell_growth(Advice& advice, long double growth, double h, long double rate) {
    advice.growth_per_step = static_cast<double>(std::exp(growth));
    advice.growth_per_second = static_cast<double>(std::exp(growth / h));
    advice.energy_ratio = static_cast<double>(std::exp(2 * (growth / h - rate)));
    advice.energy_drift = static_cast<double>(std::expm1(2 * (growth / h - rate)));
}

Advice at_step(const MethodOnSpring& method, const SpringScene& scene, double h, double wanted) {
    const DampedSpring<double>& spring = scene.fastest;
    if (!method.takes_damping && spring.zeta > 0) return refused(method);

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
            advice.reason =
                ringing_reason(all, most, zeta) + (std::isfinite(method.limit.value) ? "; " + advice.reason : "");
        }
    }
    tell_growth(advice, growth_per_step, mean_step, exact.real() * spring.omega);
    if (exact.imag() > 0 && lambda.imag() > 0)
        advice.period_error = static_cast<double>(exact.imag() * s / std::arg(lambda) - 1);
    advice.cost = method.work / mean_step;
    advice.step = h;
    if (scene.kicks && method.two_steps) advice.reason += phrase("why.restart");
    advice.right =
        (advice.verdict == Verdict::stable || taut) && advice.ringing == 0 && advice.position_error <= wanted;
    return advice;
}

}  // namespace timestep
