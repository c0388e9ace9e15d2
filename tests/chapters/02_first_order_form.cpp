// The claims of chapter 2 about equations whose answer we know.

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <cmath>
#include <limits>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "dual.hpp"

using namespace timestep;
using test_support::Dual;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

// By how much the exact solution at time t fails to solve ẋ = v and v̇ = a(x, v). The derivatives
// are those of calculus, not differences: dual numbers take them.
struct Residual {
    double velocity, force;
};
template <class Exact, class Force>
Residual residual(const Exact& model, const Force& force, double x0, double v0, double t) {
    const State<Dual> s = model.exact(State<Dual>{0, x0, v0}, Dual(t, 1));
    return {std::fabs(s.x.slope - s.v.value), std::fabs(s.v.slope - acceleration(force, s.x.value, s.v.value))};
}

}  // namespace

TEST_CASE("the exponential solves y' = lambda y", "[N11][ch2]") {
    const double lambda = GENERATE(-20.0, -1.0, 0.0, 0.5, 3.0);
    const double t = GENERATE(0.0, 0.1, 1.0, 7.0);
    const Decay decay(lambda);
    const FirstOrder<Dual> s = decay.exact(FirstOrder<Dual>{0, 2.0}, Dual(t, 1));
    const double rate_there = rate(decay, FirstOrder{t, s.y.value});
    // Both sides are λ y with one product more or less: a few roundings.
    CHECK(std::fabs(s.y.slope - rate_there) <= 8 * eps<double> * std::fabs(rate_there));
    CHECK(decay.exact(FirstOrder{1.5, 2.0}, 0.0).y == 2);
}

TEST_CASE("under gravity a body flies a parabola", "[N12][ch2]") {
    const double t = GENERATE(0.0, 0.3, 2.0, 50.0);
    const Residual r = residual(Projectile<Dual>(Dual(-9.81)), Projectile(-9.81), 2.0, 15.0, t);
    CHECK(r.velocity <= 4 * eps<double> * (15 + 9.81 * t));
    CHECK(r.force == 0);

    // y₀ + v₀ t − g t²/2, and at the top the velocity is zero.
    const Projectile fall(-9.81);
    const State s = fall.exact(State{1.0, 2.0, 15.0}, t);
    CHECK(s.t == 1 + t);
    CHECK(std::fabs(s.x - (2 + 15 * t - 9.81 * t * t / 2)) <= 8 * eps<double> * (2 + 15 * t + 5 * t * t));
    CHECK(std::fabs(fall.exact(State{0, 2.0, 15.0}, 15.0 / 9.81).v) <= 15 * eps<double>);
}

TEST_CASE("a sine and a cosine solve the spring's equation for every start", "[N14][ch2]") {
    const double omega = GENERATE(0.0, 1e-3, 1.0, 8.0, 500.0);
    const double x0 = GENERATE(-0.5, 0.0, 1.0), v0 = GENERATE(-3.0, 0.0, 2.0);
    const double t = GENERATE(0.0, 0.01, 1.0, 40.0);
    if (x0 == 0 && v0 == 0) return;
    const Spring spring(omega);
    const Residual r = residual(spring, spring, x0, v0, t);
    // Both sides mix the same sine and cosine, with a product or two more: up to eight roundings of
    // terms no larger than v₀ + ω x₀, and ω times that.
    const double speed = std::fabs(v0) + omega * std::fabs(x0);
    CHECK(r.velocity <= 8 * eps<double> * speed);
    CHECK(r.force <= 8 * eps<double> * omega * speed);
    const State at_start = spring.exact(State{0, x0, v0}, 0.0);
    CHECK(at_start.x == x0);
    CHECK(at_start.v == v0);
}

TEST_CASE("the types carry the names of the anatomy: state, start, model", "[I01][ch2]") {
    // Independent variable t, dependent variables x and v; the initial conditions are a state, the
    // model is what says the rate of change, and the solver takes them in this order.
    State<double> start{0, 1.0, 0.0};
    STATIC_REQUIRE(std::is_same_v<decltype(start.t), double>);
    STATIC_REQUIRE(std::is_same_v<decltype(start.x), double>);
    STATIC_REQUIRE(std::is_same_v<decltype(start.v), double>);
    STATIC_REQUIRE(std::is_same_v<decltype(State<Eigen::Vector3f>::x), Eigen::Vector3f>);
    STATIC_REQUIRE(std::is_same_v<decltype(State<Eigen::Vector3f>::t), float>);
    const Spring model(2.0);
    const Rate<double> slope = rate(model, start);
    CHECK(slope.x == start.v);
    CHECK(slope.v == -4);
    STATIC_REQUIRE(std::is_same_v<decltype(run(runge_kutta_4, model, start, 0.1, 10)), State<double>>);
}
