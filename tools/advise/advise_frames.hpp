#pragma once
/// \file
/// Frames of uneven length: what products of a step's matrices do, one matrix for each length
/// (I13).

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "advise_multipliers.hpp"
#include "advise_verdict.hpp"
#include <timestep/models/damped_spring.hpp>

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

/// \cond
namespace timestep::detail {

using MatrixOf = std::function<StepMatrix<long double>(long double s)>;

// So many lengths stand for all those between the shortest and the longest, evenly apart.
inline constexpr int lengths = 129;

inline double length(double shortest, double longest, int i) {
    return shortest + (longest - shortest) * i / (lengths - 1);
}

// The steps of all lengths, in double.
inline std::vector<StepMatrix<double>> steps_of(const MatrixOf& matrix, double shortest, double longest) {
    std::vector<StepMatrix<double>> all;
    for (int i = 0; i < lengths; ++i) {
        const auto a = matrix(length(shortest, longest, i));
        all.push_back({double(a.xx), double(a.xv), double(a.vx), double(a.vv)});
    }
    return all;
}

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
inline bool common_ellipse(const std::vector<StepMatrix<double>>& steps) {
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

// How fast a state grows when every frame may be as long as any other: the mean of the logarithm a
// step, and how well a thousand runs of a thousand steps know it. The seed is fixed: the advice is
// the same each time. Sizes are those of the ellipse on which the step of the middle length goes
// round, if it does: x² + v² swings by itself, and where in its oscillation a run begins and ends
// would be taken for growth. For the same reason runs begin anywhere.
struct Growth {
    double mean, deviation;
};
inline Growth random_products(const std::vector<StepMatrix<double>>& steps) {
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
inline Growth mean_growth(const std::vector<StepMatrix<double>>& steps, double zeta) {
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
inline Said varying_steps(bool one_pattern, const StabilityLimit& limit, double shortest, double longest,
                          const std::vector<StepMatrix<double>>& steps, const Growth& growth) {
    if (!std::isfinite(limit.value)) return {Verdict::stable, "whatever order the frames come in"};
    const bool sure = growth.mean > slowest_growth + 5 * growth.deviation;
    if (one_pattern) {
        const Verdict at_most = verdict(longest, limit.value), at_least = verdict(shortest, limit.value);
        if (at_most == Verdict::stable) return {at_most, reason(limit, longest) + ", at the longest frame"};
        if (at_least == Verdict::grows) return {at_least, reason(limit, shortest) + ", at the shortest frame"};
    } else if (limit.value > longest && common_ellipse(steps)) {
        return {Verdict::stable, "one ellipse holds every step, in any order"};
    }
    if (sure) return {Verdict::grows, "frames at random between the two lengths make it grow"};
    const std::string at = "its limit, ωh = " + number(limit.value);
    return {Verdict::not_proven, at + (one_pattern ? ", lies between the frames" : ", holds for a constant step")};
}

// The largest distance from the true place in the first period, of thirty runs with frames at
// random; and of two with constant ones, the shortest and the longest.
template <class Constant>
double random_position_error(const MatrixOf& matrix, const Constant& constant, const DampedSpring<long double>& spring,
                             double shortest, double longest) {
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

}  // namespace timestep::detail
/// \endcond

#if defined(__clang__)
#pragma clang diagnostic pop
#endif
