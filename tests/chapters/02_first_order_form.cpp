// The claims of chapter 2 about equations whose answer we know.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "dual.hpp"

using namespace timestep;
using test_support::Dual;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();
template <class Real>
constexpr Real pi = static_cast<Real>(3.14159265358979323846264338327950288L);

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

TEST_CASE("a constant rate gives a line, a rate of time alone an integral", "[N11][ch2]") {
    const auto constant = [](double, double) { return 0.5; };
    // Each step rounds the sum once: 16 · ε/2 · 3 at most.
    CHECK(std::fabs(run(runge_kutta_4, constant, FirstOrder{0, -1.0}, 0.25, 16).y - 1) < 24 * eps<double>);

    // With f(t) alone the four rates of RK4 are those of Simpson's rule, which is exact for cubics.
    const auto cubic = [](double t, double) { return 4 * t * t * t - 6 * t; };
    const double t = 7 * 0.3;
    const double integral = t * t * t * t - 3 * t * t;
    CHECK(std::fabs(run(runge_kutta_4, cubic, FirstOrder{0, 0.0}, 0.3, 7).y - integral) <
          100 * eps<double> * t * t * t * t);
}

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

TEMPLATE_TEST_CASE("decay is the same for numbers and vectors", "[N11][ch2]", float, double, long double) {
    using Vector = Eigen::Matrix<TestType, 2, 1>;
    const Decay decay(TestType(-2));
    const FirstOrder<Vector> both{0, Vector(1, 3)};
    const Vector y = decay.exact(both, TestType(0.5)).y;
    CHECK(y(0) == decay.exact(FirstOrder<TestType>{0, 1}, TestType(0.5)).y);
    CHECK(y(1) == decay.exact(FirstOrder<TestType>{0, 3}, TestType(0.5)).y);
    CHECK(std::fabs(y(0) - std::exp(TestType(-1))) <= 2 * eps<TestType>);
    CHECK(run(runge_kutta_4, decay, both, TestType(0.125), 8).y(0) ==
          run(runge_kutta_4, decay, FirstOrder<TestType>{0, 1}, TestType(0.125), 8).y);
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

TEST_CASE("in a plane the two directions of a throw know nothing of each other", "[N12][ch2]") {
    const Eigen::Vector2d g(0, -9.81);
    const State start{0, Eigen::Vector2d(1, 2), Eigen::Vector2d(10, 20)};
    const State<Eigen::Vector2d> s = Projectile{g}.exact(start, 1.5);
    CHECK(s.x(0) == 16);
    CHECK(s.v(0) == 10);
    CHECK(s.x(1) == Projectile(-9.81).exact(State{0, 2.0, 20.0}, 1.5).x);
}

TEST_CASE("omega = sqrt(k/m) rises with the stiffness and falls with the mass", "[N13][ch2]") {
    double before = 0;
    for (double k = 0; k < 1e4; k = 2 * k + 1) {
        const double omega = Spring<double>::from_stiffness(k, 80).omega;
        CHECK((k == 0 || omega > before));
        before = omega;
    }
    before = 1e300;
    for (double m = 1; m < 1e4; m *= 2) {
        const double omega = Spring<double>::from_stiffness(5120, m).omega;
        CHECK(omega < before);
        before = omega;
    }
    CHECK(Spring<double>::from_stiffness(5120, 80).omega == 8);
    CHECK(Spring<double>::from_stiffness(4 * 5120, 80).omega == 16);
    CHECK(Spring<double>::from_stiffness(5120, 4 * 80).omega == 4);
}

TEST_CASE("the mass on a spring obeys m x'' = -k x", "[N13][ch2]") {
    const double m = 80, k = 5120, t = GENERATE(0.0, 0.1, 1.0, 30.0);
    const auto spring = Spring<double>::from_stiffness(k, m);
    const State<Dual> s = spring.exact(State<Dual>{0, 0.25, -1.0}, Dual(t, 1));
    // Both sides mix the same sine and cosine; neither side has more than ten roundings.
    CHECK(std::fabs(m * s.v.slope + k * s.x.value) <= 20 * eps<double> * k * 0.25);
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

TEST_CASE("velocity runs a quarter of a turn ahead of position", "[N14][ch2]") {
    const Spring spring(8.0);
    const int n = 360;
    std::vector<double> x, v;
    for (int i = 0; i < n; ++i) {
        const State s = spring.exact(State{0, 0.25, 0.7}, 2 * pi<double> / 8 * i / n);
        x.push_back(s.x);
        v.push_back(s.v);
    }
    // The cross-correlation Σ x(t) v(t − lag) is largest where the shifted v looks most like x.
    int best = 0;
    double most = -1e300;
    for (int lag = 0; lag < n; ++lag) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += x[i] * v[(i - lag + n) % n];
        if (sum > most) {
            most = sum;
            best = lag;
        }
    }
    CHECK(best == n / 4);
}

TEMPLATE_TEST_CASE("the phase portrait is walked clockwise and closes", "[N15][ch2]", float, double, long double) {
    const TestType omega = 8;
    const Spring spring(omega);
    const State<TestType> start{0, TestType(0.25), TestType(-1)};
    const TestType period = 2 * pi<TestType> / omega;
    const TestType radius = std::hypot(start.x, start.v / omega);

    // The surveyor's formula on n corners: minus the area of the regular n-gon, n/2 r² sin(2π/n).
    const int n = 64;
    TestType twice = 0;
    for (int i = 0; i < n; ++i) {
        const State<TestType> a = spring.exact(start, period * i / n);
        const State<TestType> b = spring.exact(start, period * (i + 1) / n);
        twice += (a.x * b.v - b.x * a.v) / omega;
    }
    CHECK(twice < 0);
    const TestType polygon = n * radius * radius * std::sin(2 * pi<TestType> / n);
    // Each corner turns by at most 2π(ε + ε/2) too far and each of the n terms rounds a few times.
    CHECK(std::fabs(-twice - polygon) < 20 * n * eps<TestType> * radius * radius);

    // ωt is rounded by 2π ε at most, and that is how far it misses, times the radius.
    const State<TestType> end = spring.exact(start, period);
    CHECK(std::hypot(end.x - start.x, (end.v - start.v) / omega) < 10 * eps<TestType> * radius);
}

TEST_CASE("the state goes round at omega, in an ellipse when velocity keeps its own unit", "[N15][ch2]") {
    const Spring spring(8.0);
    const State start{0, 0.25, 0.0};
    for (int i = 0; i < 40; ++i) {
        const double t = 0.05 * i;
        const State s = spring.exact(start, t);
        // The angle in the portrait (x, v/ω) is −ωt; compare as sine and cosine.
        CHECK(std::fabs(s.x - 0.25 * std::cos(8 * t)) < 4 * eps<double>);
        CHECK(std::fabs(s.v / 8 + 0.25 * std::sin(8 * t)) < 4 * eps<double>);
        const double ellipse = s.x * s.x / (0.25 * 0.25) + s.v * s.v / (4 * 0.5 * 0.5 * 4);
        CHECK(std::fabs(ellipse - 1) < 16 * eps<double>);
    }
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

TEMPLATE_TEST_CASE("a standing character gives way by g / omega^2", "[I14][ch2]", float, double, long double) {
    const TestType mass = 80, stiffness = 5120, g = TestType(9.81), leg = 1;
    const auto spring = Spring<TestType>::from_stiffness(stiffness, mass);
    const Scene scene{spring, Projectile{-g}};

    // ÿ = −(k/m)(y − L) − g is zero at y = L − m g/k.
    const TestType sag = g / (spring.omega * spring.omega);
    CHECK(std::fabs(scene.acceleration(-sag)) <= 2 * eps<TestType> * g);
    CHECK(std::fabs((leg - sag) - (leg - mass * g / stiffness)) <= 2 * eps<TestType>);

    // About that height the character swings as the spring alone does about zero.
    const State<TestType> start{0, TestType(0.1), TestType(-2)};
    const State<TestType> shifted{0, start.x + sag, start.v};
    const TestType h = TestType(1) / 512;
    const State<TestType> end = run(runge_kutta_4, scene, start, h, 512);
    const State<TestType> alone = run(runge_kutta_4, spring, shifted, h, 512);
    // The same steps with another origin: 512 steps of some ten roundings of numbers below 3, and a
    // turned velocity counts 1/ω in the position; 512 · 10 · ε · 3 / 8 at the very worst.
    CHECK(std::fabs(end.x + sag - alone.x) < 2000 * eps<TestType>);

    // With a damper it comes to rest there.
    const Scene damped{DampedSpring<TestType>::from_stiffness(stiffness, 1280, mass), Projectile{-g}};
    const State<TestType> rest = run(runge_kutta_4, damped, start, h, 8 * 512);
    CHECK(std::fabs(rest.x + sag) < 10 * eps<TestType>);
}
