// The claims of chapter 3 that no study checks: single steps of the three Eulers, and what they cost.

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

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

struct CountedPendulum : Pendulum<double> {
    mutable long forces = 0, slopes = 0;
    using Pendulum::Pendulum;
    double acceleration(double x) const { return ++forces, Pendulum::acceleration(x); }
    double slope_x(double x) const { return ++slopes, Pendulum::slope_x(x); }
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

TEST_CASE("implicit Euler pays with solves and gets stability", "[I05][ch3]") {
    const CountedPendulum explicit_one(1.0), implicit_one(1.0);
    const long steps = 1000;
    run(semi_implicit_euler, explicit_one, State{0, 1.0, 0.5}, 0.1, steps);
    run(implicit_euler, implicit_one, State{0, 1.0, 0.5}, 0.1, steps);
    CHECK(explicit_one.forces == steps);
    CHECK(explicit_one.slopes == 0);
    // At least one Newton round, and one more to see that it has converged.
    CHECK(implicit_one.forces >= 2 * steps);
    CHECK(implicit_one.slopes >= 2 * steps);
    // On a spring a hundred times too stiff for the explicit methods it goes on, and to rest.
    const Spring stiff(200.0);
    const State calm = run(implicit_euler, stiff, State{0, 1.0, 0.5}, 1.0, 10);
    const State wild = run(semi_implicit_euler, stiff, State{0, 1.0, 0.5}, 1.0, 10);
    CHECK(std::hypot(calm.x, calm.v / 200) < 1e-10);
    CHECK(std::hypot(wild.x, wild.v / 200) > 1e10);
}
