#pragma once
/// \file
/// How far from the true place will it be? Of a spring let go at rest, the largest distance between
/// a method's positions and the exact ones in the first period, from powers of the step's matrix
/// (I13).

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <timestep/methods/bdf2.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/stability.hpp>
#include "advise_multipliers.hpp"

/// \cond
namespace timestep::detail {

template <std::size_t N>
using Column = std::array<long double, N>;
template <std::size_t N>
using Square = std::array<Column<N>, N>;  // row by row

template <std::size_t N>
Column<N> times(const Square<N>& a, const Column<N>& x) {
    Column<N> y{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) y[i] += a[i][j] * x[j];
    return y;
}
template <std::size_t N>
Square<N> squared(const Square<N>& a) {
    Square<N> b{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
            for (std::size_t k = 0; k < N; ++k) b[i][k] += a[i][j] * a[j][k];
    return b;
}

// A method on one spring, from rest at x = 1 or thrown from x = 0 with v = 1: what it holds after
// its first step, and the matrix of every further one. The position comes first, then the velocity.
template <std::size_t N>
struct Motion {
    Column<N> first;
    Square<N> step;
};
template <class Method>
Motion<2> motion(const Method& method, long double zeta, long double s, bool thrown = false) {
    const auto a = matrix_of(method, zeta, s);
    return {thrown ? Column<2>{a.xv, a.vv} : Column<2>{a.xx, a.vx}, {{{a.xx, a.xv}, {a.vx, a.vv}}}};
}
// BDF2 holds two states, and makes the first step as the library's does.
inline Motion<4> motion(const Bdf2&, long double zeta, long double s, bool thrown = false) {
    const DampedSpring<long double> spring(1, zeta);
    const State<long double> start{0, thrown ? 0.0L : 1.0L, thrown ? 1.0L : 0.0L}, first = bdf2.start(spring, start, s);
    Motion<4> made{{first.x, first.v, start.x, start.v}, {}};
    for (std::size_t i = 0; i < 4; ++i) {
        Column<4> y{};
        y[i] = 1;
        const auto next = bdf2.step(spring, State<long double>{0, y[2], y[3]}, State<long double>{s, y[0], y[1]}, s);
        const Column<4> image{next.x, next.v, y[0], y[1]};
        for (std::size_t row = 0; row < 4; ++row) made.step[row][i] = image[row];
    }
    return made;
}

// How many steps the reader looks at: those of one period, 2π/ω, or beyond ζ = 1 of 2π over the
// slow decay's rate; one at least. Where there are fewer than three we look at eight, so that no
// chance hit counts.
inline long long steps_of_first_swing(long double zeta, long double s) {
    const long double pi = std::numbers::pi_v<long double>;
    const long double steps = std::floor(2 * pi / (s * std::abs(exact_rate(zeta))) * (1 + 1e-12L));
    return steps < 3 ? 8 : static_cast<long long>(steps);
}

// Keeps the largest distance. Between neighbours in a row of equal strides the distance is a smooth
// curve, so the top of a parabola through three of them stands for what lies between.
class Farthest {
public:
    void look(long double distance) {
        raise(distance);
        const long double bend = last_[0] - 2 * last_[1] + distance, slope = distance - last_[0];
        const long double middle = std::abs(last_[1]);
        if (seen_ >= 2 && middle >= std::abs(last_[0]) && middle >= std::abs(distance) && bend != 0)
            raise(last_[1] - slope * slope / (8 * bend));
        last_[0] = last_[1], last_[1] = distance, ++seen_;
    }
    void raise(long double distance) {
        if (!(std::abs(distance) <= most_)) most_ = std::abs(distance);
        if (std::isnan(most_)) most_ = std::numeric_limits<long double>::infinity();
    }
    void new_stride() { seen_ = 0; }
    long double most() const { return most_; }

private:
    long double last_[2] = {0, 0}, most_ = 0;
    int seen_ = 0;
};

// How far the positions get from those of a spring let go at rest, or the velocities from those of
// one thrown. Every one of the first 256 steps, then 128 in each doubling, up to the last. An
// oscillation gets 128 samples or more, and a curve that bends no harder than t sin t rises between
// them by a thousandth of itself, of which the parabola leaves a hundredth; a fast decay, which is
// over long before the slow one, is seen at its own pace. A part that turns its sign at every step
// shows beside each sample, in the step after it.
template <std::size_t N>
long double farthest(const Motion<N>& motion, const DampedSpring<long double>& spring, long double s, long long steps,
                     bool thrown = false) {
    const std::size_t seen = thrown ? 1 : 0;
    const auto exact = [&](long double t) {
        const auto a = spring.exact(State<long double>{0, 1, 0}, t), b = spring.exact(State<long double>{0, 0, 1}, t);
        return Square<2>{{{a.x, b.x}, {a.v, b.v}}};
    };
    std::vector<Square<N>> powers{motion.step};
    std::vector<Square<2>> truths{exact(s)};
    Column<N> now = motion.first;
    Column<2> truth{truths[0][0][seen], truths[0][1][seen]};
    Farthest distance;
    long long n = 1;
    const auto go = [&](std::size_t doublings) {
        now = times(powers[doublings], now), truth = times(truths[doublings], truth);
        n += 1LL << doublings;
        doublings == 0 ? distance.raise(now[seen] - truth[seen]) : distance.look(now[seen] - truth[seen]);
    };
    distance.raise(now[seen] - truth[seen]);
    while (n < steps && n < 256) go(0);
    std::size_t doublings = 0;
    while (n + (2LL << doublings) <= steps) {
        ++doublings;
        powers.push_back(squared(powers.back()));
        truths.push_back(exact(s * static_cast<long double>(1LL << doublings)));
        const long long stride = 1LL << doublings;
        distance.new_stride();
        for (int i = 0; i < 128 && n + stride <= steps; ++i) {
            go(doublings);
            if (n < steps) distance.raise(times(powers[0], now)[seen] - times(truths[0], truth)[seen]);
        }
        if (n + stride > steps) break;
    }
    for (std::size_t i = doublings + 1; i-- > 0;) {  // the rest of the way to the last step
        distance.new_stride();
        while (n + (1LL << i) <= steps) go(i);
    }
    return distance.most();
}

// A step that changes the state by less than double can tell moves nothing: all of the motion is
// missing.
template <class Method>
double position_error(const Method& method, long double zeta, long double s) {
    const long double lost = roundoff(zeta, s);
    if (lost >= 1) return 1;
    const long double off =
        farthest(motion(method, zeta, s), DampedSpring<long double>(1, zeta), s, steps_of_first_swing(zeta, s));
    return static_cast<double>(std::fmax(off, lost));
}

// Beyond this damping ratio the fast of the two decays is less than a hundredth of the motion of a
// spring that is let go at rest, p/(q − p) with the rates p and q: its positions do not show what
// becomes of a velocity.
inline constexpr double hidden_decay = 5.1;

// Is the fast decay hidden in the positions but visible after a throw, with at least three steps in
// its 2π/q? (If roundoff swallows the slow motion, no step is right anyway.)
inline bool thrown_counts(double zeta, double s) {
    const long double exact_zeta = static_cast<long double>(zeta), exact_s = static_cast<long double>(s);
    if (zeta <= hidden_decay || roundoff(exact_zeta, exact_s) >= 1) return false;
    return exact_s / std::abs(exact_rate(exact_zeta)) <=
           2 * std::numbers::pi_v<long double> / 3;  // 1/p is q, as ω is 1
}

// The largest error of the velocity, over the throw's, until the fast decay is over, 2π/q.
template <class Method>
double velocity_error(const Method& method, long double zeta, long double s) {
    const long double steps =
        std::floor(2 * std::numbers::pi_v<long double> * std::abs(exact_rate(zeta)) / s * (1 + 1e-12L));
    return static_cast<double>(farthest(motion(method, zeta, s, true), DampedSpring<long double>(1, zeta), s,
                                        steps < 3 ? 8 : static_cast<long long>(std::fmin(steps, 1e18L)), true));
}

}  // namespace timestep::detail
/// \endcond
