// The claims of chapter 3 about single steps of the three Eulers.

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

TEST_CASE("semi-implicit Euler asks for the force as often as explicit Euler: once a step", "[N29][ch3]") {
    const CountedSpring one, other;
    const State e = run(explicit_euler, one, State{0, 1.0, 0.0}, 0.1, 1000);
    const State s = run(semi_implicit_euler, other, State{0, 1.0, 0.0}, 0.1, 1000);
    CHECK(one.forces == 1000);
    CHECK(other.forces == 1000);
    CHECK(amplitude(e, 1.0) > 100);  // and yet
    CHECK(amplitude(s, 1.0) < 1.1);
}
