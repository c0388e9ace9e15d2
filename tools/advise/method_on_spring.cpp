// A method on one damped spring: its error in the first period, what rings, and which steps are right.

#include "method_on_spring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#if defined(__clang__)  // what is long double here is meant to be
#pragma clang diagnostic ignored "-Wdouble-promotion"
#endif

namespace timestep {

namespace {

using detail::matrix_of, detail::multipliers;

long double roundoff(long double zeta, long double s) {
    return std::fmin(1.0L, rounded / (s * std::abs(exact_rate(zeta))));
}

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
Motion<4> motion(const Bdf2&, long double zeta, long double s, bool thrown = false) {
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
long long steps_of_first_swing(long double zeta, long double s) {
    const long double pi = 3.14159265358979323846L;
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

// The largest error of the velocity, over the throw's, until the fast decay is over, 2π/q.
template <class Method>
double velocity_error(const Method& method, long double zeta, long double s) {
    const long double steps = std::floor(2 * 3.14159265358979323846L * std::abs(exact_rate(zeta)) / s * (1 + 1e-12L));
    return static_cast<double>(farthest(motion(method, zeta, s, true), DampedSpring<long double>(1, zeta), s,
                                        steps < 3 ? 8 : static_cast<long long>(std::fmin(steps, 1e18L)), true));
}

template <class Method>
MethodOnSpring judged(const Method& method, double zeta, double least_zeta, bool several, bool thrown) {
    constexpr bool new_damping = std::is_same_v<Method, SemiImplicitEulerNewDamping>;
    const StabilityLimit at_once = stability_limit(method, zeta);
    return {method.name,
            method.cost.evaluations + method.cost.solves,
            Method::takes_damping,
            Method::steps_commute,
            std::is_same_v<Method, Bdf2>,
            std::is_same_v<Method, ImplicitEuler>,
            new_damping,
            new_damping && several && zeta > 0 ? StabilityLimit{2, "2"} : at_once,
            stability_limit(method, least_zeta),
            at_once,
            [=](long double s) { return multipliers(method, zeta, s); },
            [=](long double s) {
                const double let_go = position_error(method, zeta, s);
                return thrown ? std::fmax(let_go, velocity_error(method, zeta, s)) : let_go;
            },
            [=](long double s) { return velocity_error(method, zeta, s); },
            [=](long double s) { return matrix_of(when_step_changes(method), zeta, s); }};
}

// The position error of a constant step with ωh = s; infinite where it is not stable or rings.
double error_of(const MethodOnSpring& method, double zeta, double s) {
    const bool fine = verdict(s, method.limit.value) == Verdict::stable && ringing(method.multipliers(s), zeta, s) == 0;
    return fine ? method.position_error(s) : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<MethodOnSpring> methods_on_spring(double zeta, double least_zeta, bool several, bool thrown) {
    std::vector<MethodOnSpring> all;
    for_each_spring_method(
        [&](const auto& method) { all.push_back(judged(method, zeta, least_zeta, several, thrown)); });
    return all;
}

// How wrong frequency and decay are: the motion's exponent ln λ / h, or the spring that has both
// such exponents. Of that spring their sum is −2ζ'ω' and their product ω'², and it is as wrong as
// ω' and ζ'ω' are. Near ζ = 1, where the two exponents meet, they are split by the root of any
// change of the spring: so one exponent says too much there, and far beyond, where the fast one is
// soon over, the spring does. The smaller counts.
double rate_error(const std::vector<Complex>& all, long double zeta, long double s) {
    const Complex a = std::log(all.front()) / s,
                  b = std::log(all[all.size() / 2]) / s;  // BDF2's come in pairs
    const long double frequency = std::abs(std::sqrt(a * b) - 1.0L);
    const long double damping = std::abs(a + b + 2 * zeta) / (2 * std::max(zeta, 1.0L));
    const Complex exact = exact_rate(zeta);
    const long double error = std::fmin(std::hypot(frequency, damping), std::abs(a - exact) / std::abs(exact));
    return static_cast<double>(std::fmax(error, roundoff(zeta, s)));
}

// A number for people.
std::string number(double value, int digits) {
    char text[32];
    const bool plain = std::abs(value) >= 1000 && std::abs(value) < 999999.5 && digits < 7;
    if (plain)
        std::snprintf(text, sizeof text, "%.0f", value);
    else
        std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

// The most negative multiplier that rings; 0 where none does. A real one has no oscillation to
// follow. A complex one stands for an oscillation, which turns its sign by itself: it rings where
// the true motion keeps less than half as much of it (there ζ < 1, and the true one keeps e^(−ζs) a
// step).
long double ringing(const std::vector<Complex>& all, long double zeta, long double s) {
    long double most = 0;
    for (const Complex& each : all) {
        const bool no_swing = each.imag() == 0 || 2 * std::exp(-zeta * s) < std::abs(each);
        if (no_swing && each.real() < rings_below) most = std::min(most, each.real());
    }
    return most;
}

bool thrown_counts(double zeta, double s) {
    const long double exact_zeta = static_cast<long double>(zeta), exact_s = static_cast<long double>(s);
    if (zeta <= hidden_decay || roundoff(exact_zeta, exact_s) >= 1) return false;
    return exact_s / std::abs(exact_rate(exact_zeta)) <= 2 * 3.14159265358979323846L / 3;  // 1/p is q, as ω is 1
}

double last_good(const std::function<bool(double)>& good, double low, double high) {
    for (int i = 0; i < 40; ++i) {
        const double middle = low + (high - low) / 2;
        (good(middle) ? low : high) = middle;
    }
    return low;
}

// The error first rises from zero, but it need not go on rising: at longer steps errors of
// frequency and damping may come to cancel. Those steps are not searched for. We begin where
// roundoff alone is as much as wanted. The error has teeth: as s grows the last step leaves the
// first period, and what was farthest off is no longer looked at. It is largest at the end of a
// tooth, s = end/n, where n steps just fit into the period. So we go from such end to such end,
// skipping some where they are close or the error far below, then back to the first tooth that goes
// wrong, and within it by bisection.
StepRange first_right(const MethodOnSpring& method, double zeta, double wanted) {
    const double slow = static_cast<double>(std::abs(exact_rate(zeta)));
    const double swing = 2 * 3.141592653589793 / slow;
    const auto error = [&](double s) { return error_of(method, zeta, s); };
    const auto good = [&](double s) { return error(s) <= wanted; };
    const auto end_of = [&](double n) { return swing / n; };
    const double end = std::min(method.limit.value, 100 * (1 + zeta));  // by then the slow decay is over in a step
    double from = 1.0001 * static_cast<double>(rounded) / (wanted * slow);
    const double shortest = std::max(from, wanted / (10 + 20 * zeta));  // up to here the error rises
    const bool from_there = shortest < end && good(shortest);
    while (!from_there && from < end && !good(from)) from *= 1.05;
    if (!(from < end)) return {};
    double low = from_there ? shortest : from, high = low;
    double n = std::floor(swing / low);
    if (n > 1 && end_of(n) < low) --n;
    double right = n + 1;  // the last tooth that was right to its end
    while (n >= 1) {
        const double off = error(end_of(n));
        if (!(off <= wanted)) break;
        low = end_of(n), right = n;
        n = std::ceil(n / (off < wanted / 16 ? 2 : off < wanted / 4 ? 1.2 : 1.05)) - 1;
    }
    if (n >= 1) {
        double wrong = n;
        while (right - wrong > 1) {
            const double between = std::floor((right + wrong) / 2);
            (good(end_of(between)) ? right : wrong) = between;
        }
        low = std::max(low, end_of(right) * (1 + 1e-9)), high = end_of(wrong);
        if (!good(low)) low = std::max(shortest, end_of(right));
    } else {  // longer than an oscillation: no teeth
        high = low;
        while (good(high)) low = high, high *= 1.05;
    }
    return {from, last_good(good, low, high)};
}

}  // namespace timestep
