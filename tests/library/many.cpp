// Many springs and many bodies, in packs: each moves as it does alone.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/rigid/many_bodies.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/parallel_for.hpp>
#include <timestep/springs.hpp>

using namespace timestep;
using Catch::Matchers::Message;

TEMPLATE_TEST_CASE("springs in packs move as each does alone, however many there are", "[library][ch8]", float,
                   double) {
    using Real = TestType;
    const Real h = Real(0.01);
    const auto compare = [&](const auto& method, int count, long steps) {
        Springs<Real> springs;
        std::vector<Spring<Real>> models;
        std::vector<State<Real>> alone;
        for (int i = 0; i < count; ++i) {
            models.emplace_back(Real(1 + 0.37 * (i % 300)));
            alone.push_back({0, Real(1 - 0.01 * i), Real(0.5 * i)});
            springs.add(models.back(), alone.back().x, alone.back().v);
        }
        REQUIRE(springs.size() == std::size_t(count));
        for (int pass = 0; pass < 3; ++pass) {
            springs.step(method, h, steps);
            for (int i = 0; i < count; ++i) {
                for (long n = 0; n < steps; ++n) alone[i] = method.step(models[i], alone[i], h);
                INFO(count << " springs, " << steps << " steps, spring " << i);
                REQUIRE(springs[i].x == alone[i].x);
                REQUIRE(springs[i].v == alone[i].v);
                REQUIRE(springs[i].t == Real(springs.t));
            }
            REQUIRE(std::fabs(springs.t - double(pass + 1) * double(steps) * double(h)) < 1e-12);
        }
    };
    // Up to two blocks of packs and a pack more: every way in which the last ones may be left over.
    for (int count = 0; count <= 17 * native_width<Real> + 1; ++count) compare(semi_implicit_euler, count, count % 3);
    compare(semi_implicit_euler, 1000, 1);
    compare(semi_implicit_euler, 1003, 16);
    compare(velocity_verlet, 1003, 64);
}

TEST_CASE("springs refuse a state that is not finite, and add nothing", "[library][ch8]") {
    Springs<float> springs;
    springs.add(Spring(1.0f), 1, 0);
    CHECK_THROWS_MATCHES(springs.add(Spring(1.0f), std::nanf(""), 0), std::invalid_argument,
                         Message("position = nan: must be a finite number"));
    CHECK_THROWS_AS(springs.add(Spring(1.0f), 0, INFINITY), std::invalid_argument);
    CHECK(springs.size() == 1);
    CHECK(springs.packs() == 1);
}

// In `float` a sum of steps of 1/60 s is 2.8 s short by then.
TEST_CASE("springs and bodies in packs know the time after an hour", "[library][ch8]") {
    const float h = 1 / 60.0f;
    const long hour = 216000;
    const double right = double(hour) * double(h);
    Springs<float> springs;
    springs.add(Spring(1.0f), 1, 0);
    springs.step(semi_implicit_euler, h, hour);
    CHECK(std::fabs(springs.t - right) < 1e-6);
    CHECK(springs[0].t == float(right));
    ManyBodies<float, UniformInertia> balls;
    balls.add(sphere(1.0f, 1.0f), Quaternion<float>::Identity(), Vector3<float>(1, 2, 3));
    for (long n = 0; n < hour; ++n) balls.step(passive_gyroscopic, h);
    CHECK(std::fabs(balls.t - right) < 1e-6);
    CHECK(balls.state<UniformInertia>(0).t == float(right));
}

namespace {

// Shapes of three kinds, each a little different.
template <class Real>
struct Shapes {
    static Real side(int i) { return Real(1 + 0.1 * (i % 7)); }
    static auto ball(int i) { return sphere(Real(1), side(i)); }
    static auto needle(int i) { return staff(Real(1), side(i), Real(0.1) * side(i + 2)); }
    static auto brick(int i) { return box(Real(1), side(i), side(i + 1), side(i + 4)); }
};

// No component of ω is small in the body, so that every needle and every brick does wobble.
template <class Real>
RigidState<Real> wobbling(std::mt19937& random) {
    RigidState<Real> s{0, {}, {}};
    for (int k = 0; k < 4; ++k) s.q.coeffs()[k] = Real(std::normal_distribution<double>()(random));
    s.q.normalize();
    Vector3<Real> in_body;
    for (int k = 0; k < 3; ++k) {
        const double size = std::uniform_real_distribution<double>(1, 5)(random);
        in_body[k] = Real(random() % 2 ? size : -size);
    }
    s.omega = s.q * in_body;
    return s;
}

template <class Real>
using AllKinds = ManyBodies<Real, UniformInertia, SymmetricInertia, PrincipalInertia>;

// 20 steps of 16 ε: see below.
template <class Real>
constexpr double allowed = 20 * 16 * double(std::numeric_limits<Real>::epsilon());

// The same state as alone; the angular velocity has changed since the start, or has not.
template <class Real>
void same_state(const char* name, const RigidState<Real>& is, const RigidState<Real>& alone,
                const RigidState<Real>& start, bool wobbles) {
    INFO(name);
    REQUIRE(std::fabs(double(is.t - alone.t)) <= allowed<Real>);
    REQUIRE(double((is.q.coeffs() - alone.q.coeffs()).norm()) <= allowed<Real>);
    REQUIRE(double((is.omega - alone.omega).norm()) <= allowed<Real> * double(start.omega.norm()));
    const double change = double((alone.omega - start.omega).norm());
    CHECK((wobbles ? change > 0.01 : change == 0));
}

// Steps `count` bodies of each kind in packs, and each of them alone.
template <class Real, class Solver>
void turn_as_alone(const Solver& solver, int count) {
    using Shape = Shapes<Real>;
    const Real h = Real(1) / 60;
    AllKinds<Real> all;
    std::mt19937 random(std::uint32_t(count) + 1);
    std::vector<RigidState<Real>> starts;
    for (int i = 0; i < count; ++i) {
        starts.push_back(wobbling<Real>(random));
        const auto& [t, q, omega] = starts.back();
        all.add(Shape::ball(i), q, omega);
        all.add(Shape::needle(i), q, omega);
        all.add(Shape::brick(i), q, omega);
    }
    for (int n = 0; n < 20; ++n) all.step(solver, h);
    const auto alone = [&](const auto& inertia, RigidState<Real> s) {
        for (int n = 0; n < 20; ++n) s = step_rotation(solver, inertia, s, h);
        return s;
    };
    for (int i = 0; i < count; ++i) {
        const auto& s = starts[std::size_t(i)];
        same_state(solver.name, all.template state<UniformInertia>(i), alone(Shape::ball(i), s), s, false);
        same_state(solver.name, all.template state<SymmetricInertia>(i), alone(Shape::needle(i), s), s, true);
        same_state(solver.name, all.template state<PrincipalInertia>(i), alone(Shape::brick(i), s), s, true);
    }
}

}  // namespace

// In `float` to the last bit but for the orientation, whose product Eigen adds in an order of its own:
// 8 ε a step (lanes.cpp), a bit more than that in the angular velocity that is turned into the body
// and back, and after a few steps both: 20 steps, 16 ε each, of sizes near one and |ω| < 10.
TEMPLATE_TEST_CASE("bodies in packs turn as each does alone, kind by kind", "[library][ch8]", float, double) {
    for (int count = 0; count <= 2 * native_width<TestType> + 1; ++count) {
        turn_as_alone<TestType>(implicit_gyroscopic, count);
        turn_as_alone<TestType>(passive_gyroscopic, count);
    }
}

TEST_CASE("a body that is not finite is refused, and nothing is added", "[library][ch8]") {
    ManyBodies<double, PrincipalInertia> boxes;
    const auto crate = box(1.0, 1.0, 2.0, 3.0);
    CHECK_THROWS_AS(boxes.add(crate, Quaternion<double>(0, 0, 0, 0), Vector3<double>(1, 2, 3)), std::invalid_argument);
    CHECK_THROWS_MATCHES(boxes.add(crate, Quaternion<double>::Identity(), Vector3<double>(1, std::nan(""), 3)),
                         std::invalid_argument, Message("body: its state must be finite, its orientation not zero"));
    // 1e200 is a number, its square is none; in `float` neither is that of 1e25.
    CHECK_THROWS_MATCHES(boxes.add(crate, Quaternion<double>::Identity(), Vector3<double>(0, 1e200, 0)),
                         std::invalid_argument, Message("speed = 1e+200: must be so low that its square is a number"));
    ManyBodies<float, UniformInertia> balls;
    const auto add = [&](float speed) {
        balls.add(sphere(1.0f, 1.0f), Quaternion<float>::Identity(), Vector3<float>(0, 0, speed));
    };
    CHECK_THROWS_AS(add(1e25f), std::invalid_argument);
    CHECK(balls.size<UniformInertia>() == 0);
    CHECK_NOTHROW(add(1e18f));
    CHECK(boxes.size<PrincipalInertia>() == 0);
    CHECK(boxes.packs<PrincipalInertia>().empty());
}

// A length other than one would be a stretch, and the energy would go with it.
TEMPLATE_TEST_CASE("an orientation that is too long or too short is a rotation all the same", "[library][ch8]", float,
                   double) {
    using Real = TestType;
    using Limits = std::numeric_limits<Real>;
    const auto crate = box(Real(1), Real(1), Real(2), Real(3));
    const Quaternion<Real> even(Real(0.5), Real(0.5), Real(-0.5), Real(0.5));
    const Vector3<Real> omega(1, 2, 3);
    for (const Real size :
         {Real(1), Real(2), Real(10), Real(1e-25), Real(1e25), Limits::denorm_min() * 4, Limits::max()}) {
        ManyBodies<Real, PrincipalInertia> boxes;
        boxes.add(crate, Quaternion<Real>(even.coeffs() * size), omega);
        boxes.add(crate, Quaternion<Real>(0, 0, size, 0), omega);
        INFO("size " << size);
        const RigidState<Real> start = boxes.template state<PrincipalInertia>(0);
        CHECK((start.q.coeffs() - even.coeffs()).norm() <= 4 * Limits::epsilon());
        CHECK(boxes.template state<PrincipalInertia>(1).q.coeffs() == Quaternion<Real>(0, 0, 1, 0).coeffs());
        const Real E = kinetic_energy(crate, start);
        boxes.step(cayley_gyroscopic, Real(1) / 60);
        const RigidState<Real> end = boxes.template state<PrincipalInertia>(0);
        CHECK(is_finite(end));
        CHECK(std::fabs(kinetic_energy(crate, end) / E - 1) < 64 * Limits::epsilon());
    }
    const Quaternion<Real> huge(Limits::max(), Limits::max(), -Limits::max(), Limits::max());
    CHECK((as_rotation(huge).coeffs() - even.coeffs()).norm() <= 4 * Limits::epsilon());
    // A rotation stays what it is, to the last bit.
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
        const Quaternion<Real> q = wobbling<Real>(random).q;
        REQUIRE(as_rotation(q).coeffs() == q.coeffs());
    }
}

TEST_CASE("threads share the work: every part once, and no share is empty", "[library][ch8]") {
    for (const std::size_t count : {0, 1, 2, 7, 1000})
        for (const unsigned threads : {0u, 1u, 2u, 3u, 8u}) {
            std::vector<int> seen(count, 0);  // no two shares overlap, so no two threads meet here
            std::atomic<int> calls = 0, empty = 0;
            parallel_for(count, threads, [&](std::size_t first, std::size_t last) {
                ++calls, empty += first == last;
                for (std::size_t i = first; i < last; ++i) ++seen[i];
            });
            for (const int times : seen) REQUIRE(times == 1);
            if (count > 0) CHECK((empty == 0 && std::size_t(calls) <= count));
        }
}
