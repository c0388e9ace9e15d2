// The claims of chapter 2 about the mass-spring-damper, for every damping ratio.

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <cmath>
#include <limits>

#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>

#include "dual.hpp"

using namespace timestep;
using test_support::Dual;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

}  // namespace

TEST_CASE("the damped solution solves the equation, for zeta below, at and above 1", "[N17][ch2]") {
    const double zeta = GENERATE(0.0, 0.1, 0.9, 1 - 1e-8, 1 - 1e-16, 1.0, 1 + 3e-16, 1 + 1e-8, 1.1, 3.0, 1e4);
    const double omega = GENERATE(0.01, 1.0, 8.0, 300.0);
    const double wt = GENERATE(0.0, 0.1, 1.0, 5.0, 30.0);
    const double x0 = GENERATE(0.0, 0.25), v0 = GENERATE(-2.0, 0.0, 1.0);
    const DampedSpring legs(omega, zeta);
    const State<Dual> s = legs.exact(State<Dual>{0, x0, v0}, Dual(wt / omega, 1));
    CAPTURE(zeta, omega, wt, x0, v0);

    // Both sides of an equation are sums of the same few exponentials, each times a product or two
    // with x₀ or v₀, rounded some 20 times in all. (The exponent qt rounds by ε qt, but where that
    // is much, e^(−qt) is small: qt e^(−qt) < 0.4.) The damping's 2ζω v is the largest term of all.
    const double speed = std::fabs(v0) + omega * std::fabs(x0);
    const double force = omega * (1 + 2 * zeta) * speed;
    CHECK(std::fabs(s.x.slope - s.v.value) <= 20 * eps<double> * speed);
    CHECK(std::fabs(s.v.slope - acceleration(legs, s.x.value, s.v.value)) <= 20 * eps<double> * force);

    const State at_start = legs.exact(State{0, x0, v0}, 0.0);
    CHECK(at_start.x == x0);
    CHECK(at_start.v == v0);
}

TEST_CASE("strong damping and long times neither overflow nor cancel", "[N17][ch2]") {
    const double zeta = GENERATE(1.0, 10.0, 1e4, 1e8, 1e200);
    const DampedSpring legs(1.0, zeta);
    const State start{0, 1.0, 0.0};

    // For large ζ the slow rate is p = ω/(2ζ) (1 + 1/(4ζ²) + …): exact in double from 1e8 on.
    if (zeta >= 1e8) {
        const State s = legs.exact(start, zeta);
        CHECK(std::fabs(s.x - std::exp(-0.5)) <= 4 * eps<double>);
        CHECK(std::fabs(s.v * 2 * zeta + std::exp(-0.5)) <= 8 * eps<double>);
    }
    // When the fast exponential is gone, every start moves along v = −p x, to the last digits.
    if (zeta >= 10) {
        const double p = 1 / (zeta + std::sqrt(zeta - 1) * std::sqrt(zeta + 1));
        for (const double v0 : {0.0, -0.5, 4.0}) {
            const State s = legs.exact(State{0, 1.0, v0}, 100 / zeta + 1 / p);
            CHECK(std::fabs(s.v / (-p * s.x) - 1) <= 20 * eps<double>);
        }
    }
    for (const double t : {1e3, 1e10, 1e100, 1e300}) {
        const State s = legs.exact(start, t);
        CHECK(is_finite(s));
        CHECK((s.x >= 0 && s.x <= 1));
        CHECK(s.v <= 0);
    }
    const State gone = DampedSpring(1.0, 1.0).exact(start, 1e6);
    CHECK(gone.x == 0);
}
