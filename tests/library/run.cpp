// The loop around every picture: how often it steps, what it shows, what it refuses. And BDF2 in a game, where things
// happen between the steps.
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
    seen.clear();
    CHECK(run(bdf2, spring, start, 0.5, 0, [&](const auto& s) { seen.push_back(s); }).x == 1);
    CHECK(seen.size() == 1);
}

TEST_CASE("a two-step method starts itself and is handed the last two states", "[library]") {
    std::vector<double> seen;
    const State end =
        run(Accelerate(), spring, State{0, 0.0, 0.0}, 1.0, 4, [&](const auto& s) { seen.push_back(s.x); });
    CHECK(seen == std::vector<double>{0, 1, 3, 6, 10});
    CHECK(end.t == 4);
    CHECK(run(Accelerate(), spring, State{0, 0.0, 0.0}, 1.0, 1).x == 1);
}

TEST_CASE("a run refuses steps, counts and starts that make no sense, and says so", "[library]") {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, nan, inf})
        CHECK_THROWS_AS(run(explicit_euler, spring, start, bad, 10), std::invalid_argument);
    for (const double bad : {nan, inf, -inf})
        for (const State<double>& from : {State{bad, 1.0, 0.0}, State{0, bad, 0.0}, State{0, 1.0, bad}})
            CHECK_THROWS_AS(run(explicit_euler, spring, from, 0.5, 1), std::invalid_argument);
    CHECK_THROWS_MATCHES(run(explicit_euler, spring, start, -0.5, 1), std::invalid_argument,
                         Message("step = -0.5: must be finite and greater than zero"));
    int seen = 0;
    CHECK_THROWS_MATCHES(run(explicit_euler, spring, start, 0.5, -3, [&](const auto&) { ++seen; }),
                         std::invalid_argument, Message("steps = -3: must be finite and zero or more"));
    CHECK(seen == 0);
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

TEST_CASE("a motion by BDF2 forgets the past after a restart, and after a step of another length", "[library]") {
    Bdf2Motion motion(State<double>{0, 1, 0});
    const auto goes_on_as_anew = [&](std::initializer_list<double> lengths) {
        Bdf2Motion anew(motion.now());
        for (const double length : lengths) {
            motion.step(damped, length), anew.step(damped, length);
            CHECK(same(motion.now(), anew.now()));
        }
    };
    for (int n = 0; n < 10; ++n) motion.step(damped, h);
    const State<double> kicked{motion.now().t, motion.now().x, motion.now().v + 1};
    motion.restart(kicked);
    CHECK(same(motion.now(), kicked));
    goes_on_as_anew({h, h, h, h});
    goes_on_as_anew({2 * h, 2 * h, h, h});
}
