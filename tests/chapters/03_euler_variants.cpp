// The claims of chapter 3 about single steps of the three Eulers.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>

using namespace timestep;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

template <class Real>
Real amplitude(const State<Real>& s, Real omega) {
    return std::hypot(s.x, s.v / omega);
}

// A spring that counts how often its force is asked for.
struct CountedSpring {
    mutable long forces = 0;
    double acceleration(double x) const { return ++forces, -x; }
};

// The same spring, but its slope takes an argument, so that implicit methods think it nonlinear and
// use Newton–Raphson.
struct SpringByNewton {
    double omega;
    double acceleration(double x) const { return -omega * omega * x; }
    double slope_x(double /* x */) const { return -omega * omega; }
};

}  // namespace

TEST_CASE("explicit Euler halves its error with the step, for twice the work", "[N20][ch3]") {
    const auto error_and_work = [](long steps) {
        const CountedSpring counted;
        const State end = run(explicit_euler, counted, State{0, 1.0, 0.0}, 2.0 / steps, steps);
        const State exact = Spring(1.0).exact(State{0, 1.0, 0.0}, 2.0);
        return std::pair(std::hypot(end.x - exact.x, end.v - exact.v), counted.forces);
    };
    const auto [error, work] = error_and_work(1000);
    const auto [half_error, double_work] = error_and_work(2000);
    CHECK(double_work == 2 * work);
    // error = C h + D h², D/C of the order of 1: the ratio is 2 within some h = 0.002.
    CHECK(std::fabs(error / half_error - 2) < 0.01);
}

TEST_CASE("one step of each Euler is what hand arithmetic gives", "[N21][ch3]") {
    // ω = 2, h = 1/4, from x = 1, v = 3: every number is a fraction of a power of two, so no rounding.
    const Spring spring(2.0);
    const State start{0, 1.0, 3.0};
    const State e = explicit_euler.step(spring, start, 0.25);  // a = −4
    CHECK(e.t == 0.25);
    CHECK(e.v == 2.0);
    CHECK(e.x == 1.75);
    const State s = semi_implicit_euler.step(spring, start, 0.25);
    CHECK(s.v == 2.0);
    CHECK(s.x == 1.5);
    // Implicit: v₂ = (v₁ − hω²x₁)/(1 + h²ω²) = 2/(5/4) and x₂ = 1 + v₂/4.
    const State i = implicit_euler.step(spring, start, 0.25);
    CHECK(std::fabs(i.v - 1.6) <= 2 * eps<double>);
    CHECK(std::fabs(i.x - 1.4) <= 2 * eps<double>);
}

TEMPLATE_TEST_CASE("explicit Euler multiplies the amplitude by sqrt(1 + (omega h)^2) a step", "[N22][ch3]", float,
                   double, long double) {
    using Real = TestType;
    for (const Real wh : {Real(0.01), Real(0.1), Real(0.5), Real(2)}) {
        const Real omega = 3, h = wh / omega;
        const int n = 60;
        const State<Real> end = run(explicit_euler, Spring<Real>(omega), State<Real>{0, 1, 0}, h, n);
        const Real predicted = std::pow(1 + (omega * h) * (omega * h), Real(n) / 2);
        // Each step rounds x and v a handful of times, at most 6 ε of the amplitude; pow as much again.
        CHECK(std::fabs(amplitude<Real>(end, omega) / predicted - 1) < 12 * n * eps<Real>);
    }
}

TEST_CASE("the eigenvalues of the three step matrices are the closed forms", "[N23][ch3]") {
    const auto check = [](const auto& method, double wh, std::complex<double> expected) {
        const auto a = step_matrix(method, Spring(1.0), wh);
        const auto [first, second] = eigenvalues(a);
        // At a double eigenvalue a rounding of ε moves the eigenvalues by √ε; away from it by ε.
        const double allowed = 16 * std::max(1.0, std::abs(expected)) *
                               (std::fabs(wh - 2) < 0.1 ? std::sqrt(eps<double>) : eps<double> * 4);
        const auto is_expected = [&](const std::complex<double>& lambda) {
            return std::min(std::abs(lambda - expected), std::abs(lambda - std::conj(expected))) < allowed;
        };
        CHECK(is_expected(first));
        CHECK(is_expected(second));
        // det(A − λ1) = 0; and where λ is off by δ, that is δ times its distance from the other one.
        for (const auto& lambda : {first, second, expected})
            CHECK(std::abs((a.xx - lambda) * (a.vv - lambda) - a.xv * a.vx) <
                  allowed * (std::abs(first - second) + allowed));
        CHECK(std::abs(first + second - a.trace()) < allowed);
    };
    for (const double wh : {0.01, 0.3, 1.0, 1.9, 1.99, 2.0}) {
        check(explicit_euler, wh, {1, wh});
        check(implicit_euler, wh, 1.0 / std::complex(1.0, wh));
        const double c = 1 - wh * wh / 2;
        check(semi_implicit_euler, wh, {c, std::sqrt(std::max(0.0, 1 - c * c))});
    }
}

TEST_CASE("a magnitude of exactly one is bounded, but where the matrix is defective", "[N23][ch3]") {
    const auto reach = [](double wh, long steps) {
        double most = 0;
        run(semi_implicit_euler, Spring(1.0), State{0, 1.0, 0.0}, wh, steps,
            [&](const auto& s) { most = std::max(most, amplitude(s, 1.0)); });
        return most;
    };
    CHECK(std::fabs(spectral_radius(step_matrix(semi_implicit_euler, Spring(1.0), 1.5)) - 1) < 8 * eps<double>);
    // Bounded: on ½v² + ½x² − ½ωh xv = ½, which reaches √(x² + v²) = 1/√(1 − ωh/2), for ever.
    CHECK(reach(1.5, 1000000) < (1 + 1e-9) / std::sqrt(0.25));
    CHECK(spectral_radius(step_matrix(semi_implicit_euler, Spring(1.0), 2.0)) == 1);
    // Linear growth at ωh = 2, in whole numbers: ten times the steps, ten times as far.
    CHECK(std::fabs(reach(2.0, 10000) / reach(2.0, 1000) - 10) < 0.05);
}

TEST_CASE("the growth that a run shows is the magnitude of the eigenvalue", "[N24][ch3]") {
    for (const double omega : {0.1, 2.0, 50.0}) {
        const double h = 0.01;
        const long n = 200;
        const State end = run(explicit_euler, Spring(omega), State{0, 1.0, 0.0}, h, n);
        const double growth = std::pow(amplitude(end, omega), 1.0 / n);
        CHECK(growth > 1);
        // The n-th root takes the roundoff of n steps, 12 n ε, down to that of one.
        CHECK(std::fabs(growth - std::sqrt(1 + omega * omega * h * h)) < 20 * eps<double>);
        CHECK(std::fabs(spectral_radius(step_matrix(explicit_euler, Spring(omega), h)) - growth) < 40 * eps<double>);
    }
}

TEST_CASE("implicit Euler's closed form is Newton's answer, and its order is one", "[N26][ch3]") {
    for (const double omega : {0.5, 10.0, 1e4}) {
        const State start{0, 1.0, -2.0};
        const State closed = implicit_euler.step(Spring(omega), start, 0.1);
        const State newton = implicit_euler.step(SpringByNewton{omega}, start, 0.1);
        // Newton stops when a correction is below 4 ε; the terms it rounds are of the size of v₁ and hω²x₁.
        const double scale = (2 + 0.1 * omega * omega) / (1 + 0.01 * omega * omega);
        CHECK(std::fabs(closed.v - newton.v) < 16 * eps<double> * scale);
        CHECK(std::fabs(closed.x - newton.x) < 16 * eps<double> * (1 + scale));
        // And both solve the equation: v₂ = v₁ − hω²x₂.
        CHECK(std::fabs(closed.v - (-2.0 - 0.1 * omega * omega * closed.x)) <
              16 * eps<double> * (2 + 0.1 * omega * omega));
    }
    const auto error = [](long steps) {
        const State end = run(implicit_euler, Spring(1.0), State{0, 1.0, 0.0}, 2.0 / steps, steps);
        const State exact = Spring(1.0).exact(State{0, 1.0, 0.0}, 2.0);
        return std::hypot(end.x - exact.x, end.v - exact.v);
    };
    CHECK(std::fabs(error(1000) / error(2000) - 2) < 0.01);
}

TEST_CASE("Newton's answer solves the pendulum's implicit step", "[N26][ch3]") {
    const Pendulum pendulum(3.0);
    for (const double h : {0.01, 0.1, 1.0}) {
        const State start{0, 2.5, 1.0};
        const State s = implicit_euler.step(pendulum, start, h);
        const double residual = s.v - start.v - h * pendulum.acceleration(s.x);
        CHECK(std::fabs(residual) < 64 * eps<double> * (1 + 9 * h + 9 * h * h * std::fabs(s.v)));
        CHECK(std::fabs(s.x - start.x - h * s.v) < 4 * eps<double> * (3 + h * std::fabs(s.v)));
    }
}

TEST_CASE("Newton finds every root below omega h = 1, and not every one beyond", "[N26][ch3]") {
    const Pendulum pendulum(1.0);
    const auto missed = [&](double wh) {
        int count = 0;
        for (int i = 0; i < 100; ++i)
            for (int j = 0; j < 100; ++j) {
                const State s1{0, -3.14 + 0.0628 * i, -3 + 0.06 * j};
                const State s2 = implicit_euler.step(pendulum, s1, wh);
                count += !(std::fabs(s2.v - s1.v - wh * pendulum.acceleration(s2.x)) < 1e-9);
            }
        return count;
    };
    // The slope of v₂ − v₁ − h a(x₁ + h v₂) is 1 + (ωh)² cos x₂: below ωh = 1 it is above zero,
    // and a function that only rises is solved from anywhere. A tangent's root alone would miss 5 %.
    CHECK(missed(0.5) == 0);
    CHECK(missed(0.999) == 0);
    // At 1 it is zero at the top, and no tangent leads from there.
    const double top = std::acos(-1.0);
    CHECK(std::fabs(implicit_euler.step(pendulum, State{0, top, 0.0}, 0.999).x - top) < 1e-9);
    CHECK_FALSE(is_finite(implicit_euler.step(pendulum, State{0, top, 0.0}, 1)));
    CHECK(missed(1.5) > 0);
}

TEST_CASE("implicit Euler divides the amplitude by sqrt(1 + (omega h)^2), for every step", "[N27][ch3]") {
    for (const double wh : {1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, 1e9}) {
        const int n = 20;
        State state{0, 1.0, 0.0};
        double log_decay = 0;
        for (int i = 0; i < n; ++i) {  // back to amplitude 1 each step: 1e9²⁰ would leave the range
            state = implicit_euler.step(Spring(1.0), state, wh);
            const double size = amplitude(state, 1.0);
            log_decay += std::log(size);
            state = {0, state.x / size, state.v / size};
        }
        const double decay = std::exp(log_decay / n);
        CHECK(decay < 1);
        CHECK(std::fabs(decay * std::sqrt(1 + wh * wh) - 1) < 40 * eps<double> * (1 + std::fabs(log_decay)));
    }
}

TEST_CASE("implicit Euler forth and explicit Euler back returns to the start", "[N28][ch3]") {
    for (const double wh : {0.05, 0.2, 0.9}) {
        const Spring spring(1.0);
        State state{0, 1.0, 0.5};
        const int n = 50;
        for (int i = 0; i < n; ++i) state = implicit_euler.step(spring, state, wh);
        for (int i = 0; i < n; ++i) state = explicit_euler.step(spring, state, -wh);
        // An error of the i-th step back is multiplied by √(1 + ω²h²) in each that follows; those of the
        // way there come back with the state. Each step rounds by at most 8 ε of the amplitude.
        const double carried = std::pow(1 + wh * wh, n / 2.0);
        CHECK(std::hypot(state.x - 1, state.v - 0.5) < 2 * n * 8 * eps<double> * carried * 1.12);
        CHECK(std::fabs(state.t) < 2 * n * eps<double> * n * wh);
    }
}

TEST_CASE("semi-implicit Euler asks for the force as often as explicit Euler: once a step", "[N29][ch3]") {
    const CountedSpring one, other;
    const State e = run(explicit_euler, one, State{0, 1.0, 0.0}, 0.1, 1000);
    const State s = run(semi_implicit_euler, other, State{0, 1.0, 0.0}, 0.1, 1000);
    CHECK(one.forces == 1000);
    CHECK(other.forces == 1000);
    CHECK(amplitude(e, 1.0) > 100);  // and yet
    CHECK(amplitude(s, 1.0) < 1.1);
}
