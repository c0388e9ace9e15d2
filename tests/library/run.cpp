// The loop around every picture: how often it steps, what it shows, what it refuses. And BDF2 in a game, where things
// happen between the steps.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Core>
#include <timestep/methods.hpp>
#include <timestep/methods/bdf2.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;
using Catch::Matchers::Message;

namespace {

// Remembers the last two states: each step moves on by what the last one did, and one more.
struct Accelerate {
    template <class Model>
    State<double> start(const Model&, const State<double>& s, double h) const {
        return {s.t + h, s.x + 1, s.v};
    }
    template <class Model>
    State<double> step(const Model&, const State<double>& s0, const State<double>& s1, double h) const {
        return {s1.t + h, s1.x + (s1.x - s0.x) + 1, s1.v};
    }
};

const Spring spring(1.0);
const State start{0, 1.0, 0.0};

}  // namespace

TEST_CASE("a run shows the start and the state after each step, and returns the last", "[library]") {
    std::vector<State<double>> seen;
    const State end = run(semi_implicit_euler, spring, start, 0.5, 3, [&](const auto& s) { seen.push_back(s); });
    REQUIRE(seen.size() == 4);
    State by_hand = start;
    for (const auto& s : seen) {
        CHECK(s.t == by_hand.t);
        CHECK(s.x == by_hand.x);
        CHECK(s.v == by_hand.v);
        by_hand = semi_implicit_euler.step(spring, by_hand, 0.5);
    }
    CHECK(end.x == seen.back().x);
    CHECK(end.t == 1.5);
}

TEST_CASE("a run of no steps is where it starts", "[library]") {
    int seen = 0;
    CHECK(run(semi_implicit_euler, spring, start, 0.5, 0, [&](const auto&) { ++seen; }).x == 1);
    CHECK(run(bdf2, spring, start, 0.5, 0).x == 1);
    CHECK(seen == 1);
}

TEST_CASE("a two-step method starts itself and is handed the last two states", "[library]") {
    std::vector<double> seen;
    const State end =
        run(Accelerate(), spring, State{0, 0.0, 0.0}, 1.0, 4, [&](const auto& s) { seen.push_back(s.x); });
    CHECK(seen == std::vector<double>{0, 1, 3, 6, 10});
    CHECK(end.t == 4);
    CHECK(run(Accelerate(), spring, State{0, 0.0, 0.0}, 1.0, 1).x == 1);
}

TEMPLATE_TEST_CASE("a run refuses steps, counts and starts that make no sense", "[library]", float, double,
                   long double) {
    using Limits = std::numeric_limits<TestType>;
    const Spring<TestType> model(1);
    const State<TestType> good{0, 1, 0};
    const TestType h = TestType(0.5);
    for (const TestType bad : {TestType(0), TestType(-1), Limits::quiet_NaN(), Limits::infinity()})
        CHECK_THROWS_AS(run(explicit_euler, model, good, bad, 10), std::invalid_argument);
    CHECK_THROWS_AS(run(explicit_euler, model, good, h, -1), std::invalid_argument);
    for (const TestType bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
        CHECK_THROWS_AS(run(explicit_euler, model, State<TestType>{bad, 1, 0}, h, 1), std::invalid_argument);
        CHECK_THROWS_AS(run(explicit_euler, model, State<TestType>{0, bad, 0}, h, 1), std::invalid_argument);
        CHECK_THROWS_AS(run(explicit_euler, model, State<TestType>{0, 1, bad}, h, 1), std::invalid_argument);
    }
    int seen = 0;
    CHECK_THROWS_AS(run(explicit_euler, model, good, h, -1, [&](const auto&) { ++seen; }), std::invalid_argument);
    CHECK(seen == 0);
}

TEST_CASE("a run says what it refuses", "[library]") {
    CHECK_THROWS_MATCHES(run(explicit_euler, spring, start, -0.5, 1), std::invalid_argument,
                         Message("step = -0.5: must be finite and greater than zero"));
    CHECK_THROWS_MATCHES(run(explicit_euler, spring, start, 0.5, -3), std::invalid_argument,
                         Message("steps = -3: must be finite and zero or more"));
}

TEST_CASE("a run that blows up goes on, and its end can be asked", "[library]") {
    const State end = run(explicit_euler, Spring(1e100), State{0, 1.0, 0.0}, 1.0, 10);
    CHECK_FALSE(is_finite(end));
    CHECK(end.t == 10);
}

// Past ωh = 1 the pendulum's equation may have several roots, and Newton–Raphson may find none.
TEST_CASE("a step of an implicit method reports whether its equation is solved", "[library]") {
    const Pendulum pendulum(1.0);
    const State gentle{0, 1.0, 0.0};
    long missed = 0;
    const auto solves = [&](const auto& method) {
        CAPTURE(method.name);
        CHECK(method.try_step(pendulum, gentle, 0.5).converged);
        CHECK(method.try_step(spring, gentle, 100.0).converged);
        CHECK(method.try_step(Decay(-1.0), FirstOrder{0, 1.0}, 100.0).converged);
        CHECK(method.try_step(pendulum, gentle, 0.5).state.x == method.step(pendulum, gentle, 0.5).x);
        const double h = method.order == 1 ? 1.5 : 3;  // implicit midpoint solves over half the step
        for (int i = 0; i < 2500; ++i) {
            const State from{0, -3.14 + 0.1256 * (i % 50), -3 + 0.12 * double(i / 50)};
            const auto [state, converged] = method.try_step(pendulum, from, h);
            const double x = method.order == 1 ? state.x : (from.x + state.x) / 2;
            const double left = state.v - from.v - h * pendulum.acceleration(x);
            CHECK(converged == (std::fabs(left) < 1e-9));
            missed += !converged;
        }
    };
    solves(implicit_euler);
    solves(implicit_midpoint);
    CHECK(missed > 0);
}

// A force that counts how often it is evaluated.
struct Counting {
    mutable long evaluations = 0;
    double acceleration(double x) const { return ++evaluations, -std::sin(x); }
};

TEST_CASE("velocity Verlet evaluates the force once per step if it keeps the acceleration", "[library][I10]") {
    const Counting kept, anew;
    State<double> state{0, 1, 0};
    auto with_force = velocity_verlet.with_acceleration(kept, state);
    for (int n = 0; n < 100; ++n) {
        state = velocity_verlet.step(anew, state, n % 2 ? 0.1 : 0.05);
        with_force = velocity_verlet.step(kept, with_force, n % 2 ? 0.1 : 0.05);
    }
    CHECK(anew.evaluations == 100 * velocity_verlet.cost.evaluations);
    CHECK(kept.evaluations == 1 + 100);
    CHECK(with_force.state.x == state.x);
    CHECK(with_force.state.v == state.v);
}

// On a spring the coordinates do not know of each other, so a vector is stepped as its coordinates
// are: bit for bit, since the operations are the same.
namespace {

template <class Real, class Method>
void same_as_coordinates(const Method& method) {
    using Vector = Eigen::Matrix<Real, 3, 1>;
    const Spring<Real> model(Real(1.5));
    const Real h = Real(0.1);
    const State<Vector> from{0, Vector(1, Real(-0.3), Real(0.7)), Vector(0, Real(0.2), -1)};
    const State<Vector> end = run(method, model, from, h, 25);
    for (int i = 0; i < 3; ++i) {
        INFO(method.name << ", coordinate " << i);
        const State<Real> alone = run(method, model, State<Real>{0, from.x(i), from.v(i)}, h, 25);
        CHECK(end.t == alone.t);
        CHECK(end.x(i) == alone.x);
        CHECK(end.v(i) == alone.v);
    }
}

}  // namespace

TEST_CASE("every method steps a vector as it steps its coordinates", "[library]") {
    for_each_method([](const auto& method) { same_as_coordinates<double>(method); });
    for_each_verlet_method([](const auto& method) { same_as_coordinates<double>(method); });
}

TEMPLATE_TEST_CASE("vectors of floats are stepped", "[library]", float) {
    same_as_coordinates<TestType>(semi_implicit_euler);
    same_as_coordinates<TestType>(implicit_euler);
    same_as_coordinates<TestType>(runge_kutta_4);
    for_each_verlet_method([](const auto& method) { same_as_coordinates<TestType>(method); });
}

// A force without position or velocity: methods of order two and more are exact but for rounding.
TEMPLATE_TEST_CASE("every method of order two or more throws a ball along its parabola", "[library]", float, double) {
    const Projectile<TestType> ball(-8);
    const State<TestType> from{0, 1, 16};
    const State<TestType> exact = ball.exact(from, TestType(2));
    // 64 steps. Each rounds a position below 32 by at most three half-ulps of 32: 64·3·16 ε; velocities
    // are 16 or less and enter the position over 2 s: the same again.
    const TestType bound = 2 * 64 * 3 * 16 * std::numeric_limits<TestType>::epsilon();
    for_each_method([&](const auto& method) {
        if (method.order < 2) return;
        INFO(method.name);
        const State<TestType> end = run(method, ball, from, TestType(2) / 64, 64);
        CHECK(std::fabs(end.x - exact.x) <= bound);
        CHECK(std::fabs(end.v - exact.v) <= bound);
    });
}

namespace {

const DampedSpring<double> damped(10.0, 0.2);
constexpr double h = 1.0 / 60;

bool same(const State<double>& a, const State<double>& b) { return a.t == b.t && a.x == b.x && a.v == b.v; }

}  // namespace

TEST_CASE("left alone a motion by BDF2 is a run of it", "[library]") {
    const State<double> start{0, 1, -2};
    Bdf2Motion motion(start);
    CHECK(same(motion.now(), start));
    for (int n = 1; n <= 50; ++n) {
        motion.step(damped, h);
        CHECK(same(motion.now(), run(bdf2, damped, start, h, n)));
    }
}

TEST_CASE("after a restart a motion by BDF2 knows nothing of what was before", "[library]") {
    Bdf2Motion motion(State<double>{0, 1, 0});
    for (int n = 0; n < 10; ++n) motion.step(damped, h);
    const State<double> kicked{motion.now().t, motion.now().x, motion.now().v + 1};
    motion.restart(kicked);
    CHECK(same(motion.now(), kicked));
    Bdf2Motion anew(kicked);
    for (int n = 0; n < 10; ++n) {
        motion.step(damped, h), anew.step(damped, h);
        CHECK(same(motion.now(), anew.now()));
    }
}

TEST_CASE("a step of another length is a restart of a motion by BDF2", "[library]") {
    Bdf2Motion motion(State<double>{0, 1, 0});
    for (int n = 0; n < 10; ++n) motion.step(damped, h);
    Bdf2Motion anew(motion.now());
    for (const double length : {2 * h, 2 * h, h, h}) {
        motion.step(damped, length), anew.step(damped, length);
        CHECK(same(motion.now(), anew.now()));
    }
}
