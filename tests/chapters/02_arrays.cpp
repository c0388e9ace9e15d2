// The claims of chapter 2 about several bodies in one state, one solver for all scenes, and
// problems that have no simple answer.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <Eigen/Geometry>

#include <timestep/first_order_form.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/heun.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/midpoint.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "any_model.hpp"
#include "dual.hpp"
#include "extrapolation.hpp"

using namespace timestep;
using test_support::AnyForce;
using test_support::AnySystem;
using test_support::Dual;
using test_support::extrapolated;

namespace {

using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;
using Vector4 = Eigen::Vector4d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

// The solvers that know nothing of position and velocity.
template <class Visit>
void for_each_general_method(const Visit& visit) {
    visit(explicit_euler);
    visit(midpoint);
    visit(heun);
    visit(runge_kutta_4);
}

// Both ways to step a scene, with every solver.
template <class X, class Y>
void same_bits(const AnyForce<X>& body, const State<X>& start, const AnySystem<Y>& array,
               const FirstOrder<Y>& start_array) {
    for_each_general_method([&](const auto& method) {
        const FirstOrder<Y> moved = stacked(run(method, body, start, real_of<X>(0.01), 100));
        const FirstOrder<Y> as_array = run(method, array, start_array, real_of<X>(0.01), 100);
        CHECK(as_array.y == moved.y);
        CHECK(as_array.t == moved.t);
    });
}

// Steps a scene as a body, x and v apart, and as one array, and wants the same bits.
template <class Model, class X>
void same_as_array(const Model& model, const State<X>& start) {
    const auto start_array = stacked(start);
    using Array = decltype(start_array.y);
    same_bits(AnyForce<X>(model), start, AnySystem<std::remove_const_t<Array>>(FirstOrderForm{model}), start_array);
}

}  // namespace

TEMPLATE_TEST_CASE("n masses in one array are the n masses alone, bit for bit", "[N16][ch2]", float, double) {
    constexpr int n = 5;
    using Array = Eigen::Matrix<TestType, 2 * n, 1>;
    using One = Eigen::Matrix<TestType, 2, 1>;
    std::vector<AnySystem<One>> springs;
    for (int i = 0; i < n; ++i)
        springs.push_back(FirstOrderForm{DampedSpring<TestType>(TestType(1.7) * (i + 1), TestType(0.1) * i)});
    const AnySystem<Array> all = [&](TestType t, const Array& y) -> Array {
        Array rate;
        for (int i = 0; i < n; ++i) rate.template segment<2>(2 * i) = springs[i](t, y.template segment<2>(2 * i));
        return rate;
    };
    Array start;
    for (int i = 0; i < n; ++i) start.template segment<2>(2 * i) << TestType(1) / (i + 1), TestType(0.3) * i;

    const TestType h = TestType(1) / 60;
    for_each_general_method([&](const auto& method) {
        const Array together = run(method, all, FirstOrder<Array>{0, start}, h, 300).y;
        Array alone;
        for (int i = 0; i < n; ++i) {
            const FirstOrder<One> one{0, One(start.template segment<2>(2 * i))};
            alone.template segment<2>(2 * i) = run(method, springs[i], one, h, 300).y;
        }
        CHECK(together == alone);
    });
}

TEST_CASE("a character and a grenade go through the same solver in one array", "[N16][ch2]") {
    const AnySystem<Vector2> legs = FirstOrderForm{Scene{DampedSpring(8.0, 0.1), Projectile(-9.81)}};
    const AnySystem<Vector4> shell = FirstOrderForm{Scene{Projectile(Vector2(0, -9.81)), Drag(0.006)}};
    const AnySystem<Vector6> both = [&](double t, const Vector6& y) -> Vector6 {
        Vector6 rate;
        rate << legs(t, y.head<2>()), shell(t, y.tail<4>());
        return rate;
    };
    const FirstOrder<Vector2> a{0, Vector2(0, -3)};
    const FirstOrder<Vector4> b{0, Vector4(0, 0, 20, 20)};
    Vector6 y;
    y << a.y, b.y;
    const Vector6 end = run(runge_kutta_4, both, FirstOrder<Vector6>{0, y}, 1.0 / 60, 200).y;
    CHECK(end.head<2>() == run(runge_kutta_4, legs, a, 1.0 / 60, 200).y);
    CHECK(end.tail<4>() == run(runge_kutta_4, shell, b, 1.0 / 60, 200).y);
}

TEST_CASE("coupled masses follow the sum of their normal modes", "[N16][ch2]") {
    const CoupledSprings row(Vector4(80, 40, 10, 60), Eigen::Matrix<double, 5, 1>(5000, 300, 800, 100, 2000));
    const State start{0, Vector4(0.25, 0, -0.1, 0), Vector4(0, 1, 0, -0.5)};

    // Exact: ẋ = v and v̇ = −M⁻¹K x, with the derivatives of calculus.
    using Duals = Eigen::Matrix<Dual, 4, 1>;
    for (const double t : {0.0, 0.1, 1.0, 10.0}) {
        const State<Duals> s = row.exact(State<Duals>{0, start.x.cast<Dual>(), start.v.cast<Dual>()}, Dual(t, 1));
        Vector4 x, v, x_dot, v_dot;
        for (int i = 0; i < 4; ++i) {
            x(i) = s.x(i).value;
            v(i) = s.v(i).value;
            x_dot(i) = s.x(i).slope;
            v_dot(i) = s.v(i).slope;
        }
        // The decomposition is good to some ε of its largest ω² = 130 and ω; the ratio of masses
        // is 8.
        const double top = row.frequencies()(3);
        CHECK((x_dot - v).norm() < 100 * eps<double> * top);
        CHECK((v_dot - row.acceleration(x)).norm() < 100 * eps<double> * top * top);
    }
    const State<Vector4> at_start = row.exact(start, 0.0);
    CHECK((at_start.x - start.x).norm() < 20 * eps<double>);
    CHECK((at_start.v - start.v).norm() < 40 * eps<double>);

    // And RK4 follows: late by (ωh)⁵/120 a step in the fastest mode.
    const double h = 1.0 / 512;
    const State<Vector4> end = run(runge_kutta_4, row, start, h, 512);
    const double bound = 512 * std::pow(row.frequencies()(3) * h, 5) / 120;
    CHECK((end.x - row.exact(start, 1.0).x).norm() < 4 * bound);  // 4: four modes, unequal masses
    CHECK(bound < 1e-6);
}

TEST_CASE("masses that act on each other do not move as they would alone", "[N16][ch2]") {
    const CoupledSprings row(Vector2(80, 80), Vector3(5120, 512, 5120));
    const State start{0, Vector2(0.25, 0), Vector2(0, 0)};
    // All of the first one's swing has gone over to the second after half a beat.
    const Vector2 w = row.frequencies();
    const double half_beat = 3.14159265358979 / (w(1) - w(0));
    CHECK(std::fabs(w(0) - 8) < 1e-14);  // both together: the spring between them is not stretched
    CHECK(std::fabs(w(1) - std::sqrt((5120 + 2 * 512) / 80.0)) < 1e-14);
    CHECK(row.exact(start, 0.1).x(1) > 0);  // the first one, up, pulls the second one up
    const State<Vector2> s = row.exact(start, half_beat);
    const double first = std::hypot(s.x(0), s.v(0) / 8), second = std::hypot(s.x(1), s.v(1) / 8);
    CHECK(first < 0.03);  // not nothing: v/ω takes the mean of two frequencies that differ by a tenth
    CHECK(second > 0.24);
}

TEST_CASE("one solver runs every scene and knows no position from a velocity", "[I04][ch2]") {
    same_as_array(Projectile(-9.81), State{0, 1.0, 2.0});
    same_as_array(Spring(8.0), State{0, 0.25, 0.0});
    same_as_array(DampedSpring(8.0, 0.3), State{0, 0.25, 0.0});
    same_as_array(Scene{DampedSpring(8.0, 0.1), Projectile(-9.81)}, State{0, 0.0, -3.0});
    same_as_array(Scene{Projectile(Vector2(0, -9.81)), Drag(0.006)}, State{0, Vector2(0, 0), Vector2(20, 20)});
    same_as_array(Tether(6.0, 1.0), State{0, Vector3(1.5, 0, 0.5), Vector3(0, 3, 1)});
    same_as_array(CoupledSprings(Vector2(80, 80), Vector3(5120, 512, 5120)), State{0, Vector2(0.25, 0), Vector2(0, 0)});
    same_as_array(DampedSpring(8.0f, 0.3f), State{0, 0.25f, 0.0f});

    // A first-order equation that is no body at all goes the same way.
    const FirstOrder faded = run(runge_kutta_4, Decay(-3.0), FirstOrder{0, 1.0}, 0.01, 100);
    CHECK(std::fabs(faded.y - std::exp(-3.0)) < 100 * std::pow(0.03, 5) / 120);
}

TEST_CASE("an implicit solver takes the first-order form, too", "[I04][ch2]") {
    const Scene character{DampedSpring(8.0, 0.1), Projectile(-9.81)};
    const State body = run(implicit_euler, character, State{0, 0.0, -3.0}, 0.01, 100);
    const FirstOrder<Vector2> array =
        run(implicit_euler, FirstOrderForm{character}, stacked(State{0, 0.0, -3.0}), 0.01, 100);
    // The same equations solved in another order: 100 steps of some 20 roundings of numbers below
    // 3.
    CHECK(std::fabs(array.y(0) - body.x) < 100 * 20 * 3 * eps<double>);
    CHECK(std::fabs(array.y(1) - body.v) < 100 * 20 * 3 * eps<double>);

    const Scene grenade{Projectile(Vector2(0, -9.81)), Drag(0.006)};
    const State start{0, Vector2(0, 0), Vector2(20, 20)};
    const State<Vector2> flown = run(implicit_euler, grenade, start, 0.01, 100);
    const FirstOrder<Vector4> flat = run(implicit_euler, FirstOrderForm{grenade}, stacked(start), 0.01, 100);
    CHECK((flat.y.head<2>() - flown.x).norm() < 100 * 20 * 30 * eps<double>);
}

TEST_CASE("with air resistance two independent references agree", "[I03][ch2]") {
    const Scene scene{Projectile(Vector2(0, -9.81)), Drag<double>::from_terminal_speed(40, 9.81)};
    const State start{0, Vector2(0, 0), Vector2(21, 21)};
    const AnyForce<Vector2> grenade(scene);
    const FirstOrderForm form{scene};

    // One second in 60 steps: the error that the chapter shows. Its reference takes 64 times as
    // many.
    const State<Vector2> shown = run(runge_kutta_4, grenade, start, 1.0 / 60, 60);
    const State<Vector2> reference = run(runge_kutta_4, grenade, start, 1.0 / 60 / 64, 60 * 64);
    const Vector4 second = extrapolated(form, stacked(start).y, 0.0, 0.05, 20);
    const double error = (stacked(shown).y - stacked(reference).y).norm();
    const double apart = (second - stacked(reference).y).norm();
    CHECK(error > 0);
    CHECK(apart < error / 100);

    // Straight up and down there is an exact answer: v = −v_t tanh(g t / v_t), fallen from rest.
    const AnyForce<double> fall(Scene{Projectile(-9.81), Drag<double>::from_terminal_speed(40, 9.81)});
    const State end = run(runge_kutta_4, fall, State{0, 0.0, 0.0}, 1.0 / 256, 5 * 256);
    CHECK(std::fabs(end.v + 40 * std::tanh(9.81 * 5 / 40)) < 1e-9);
    CHECK(std::fabs(end.x + 40 * 40 / 9.81 * std::log(std::cosh(9.81 * 5 / 40))) < 1e-9);
    // It falls no faster than the terminal speed, and comes close to it.
    const State later = run(runge_kutta_4, fall, State{0, 0.0, 0.0}, 1.0 / 64, 60 * 64);
    CHECK(std::fabs(later.v + 40) < 1e-9);
}

TEST_CASE("drag turns the parabola into a path that falls short and steep", "[I03][ch2]") {
    const Drag drag = Drag<double>::from_terminal_speed(40, 9.81);
    const AnyForce<Vector2> grenade(Scene{Projectile(Vector2(0, -9.81)), drag});
    const AnyForce<Vector2> vacuum(Projectile(Vector2(0, -9.81)));
    const State start{0, Vector2(0, 0), Vector2(21, 21)};
    // Where the path comes back to the ground, and at which slope.
    const auto landing = [&](const AnyForce<Vector2>& model) {
        State<Vector2> s = start;
        do s = runge_kutta_4.step(model, s, 1.0 / 1024);
        while (s.x.y() > 0);
        return s;
    };
    const State<Vector2> air = landing(grenade), none = landing(vacuum);
    CHECK(air.x.x() < 0.8 * none.x.x());
    CHECK(air.v.y() / air.v.x() < -1.2);  // steeper than the 45 degrees of the throw
    CHECK(std::fabs(none.v.y() / none.v.x() + 1) < 1e-3);
    CHECK(air.v.norm() < start.v.norm());  // and slower
}

TEST_CASE("in space a tethered mass keeps its angular momentum and its energy", "[I03][ch2]") {
    const Tether tether(6.0, 1.0);
    const AnyForce<Vector3> rope(tether);
    const State start{0, Vector3(1.6, 0, 0.4), Vector3(0, 3, 1.5)};
    const Vector3 momentum = start.x.cross(start.v);
    const auto drift = [&](long a_second) {
        double worst = 0, energy = 0;
        run(runge_kutta_4, rope, start, 1.0 / a_second, 4 * a_second, [&](const State<Vector3>& s) {
            worst = std::max(worst, (s.x.cross(s.v) - momentum).norm() / momentum.norm());
            energy = std::max(energy, std::fabs(tether.energy(s) / tether.energy(start) - 1));
        });
        return std::max(worst, energy);
    };
    // Order four at least: 16 times less for half the step; 12 leaves room for the next order.
    CHECK(drift(64) / drift(128) > 12);
    // The reference: 64 times smaller steps leave 64⁻⁴ of it, or the roundoff of 16384 steps.
    CHECK(drift(4096) < std::max(drift(64) / 1e6, 16384 * 2 * eps<double>));

    // Two references of the end state, 100 times closer than the chapter's 60 steps a second.
    const State<Vector3> fine = run(runge_kutta_4, rope, start, 1.0 / 60 / 64, 60 * 64);
    const State<Vector3> shown = run(runge_kutta_4, rope, start, 1.0 / 60, 60);
    const Vector6 other = extrapolated(FirstOrderForm{tether}, stacked(start).y, 0.0, 0.02, 50);
    CHECK((other - stacked(fine).y).norm() < (stacked(shown).y - stacked(fine).y).norm() / 100);
}

TEST_CASE("a spring without rest length is three springs that know nothing of each other", "[I03][ch2]") {
    const State start{0, Vector3(1.6, 0, 0.4), Vector3(0, 3, 1.5)};
    const State<Vector3> s = Spring(6.0).exact(start, 0.7);
    for (int i = 0; i < 3; ++i) CHECK(s.x(i) == Spring(6.0).exact(State{0, start.x(i), start.v(i)}, 0.7).x);
    CHECK((s.x.cross(s.v) - start.x.cross(start.v)).norm() < 20 * eps<double> * 6);
    // The tether of rest length zero is that spring.
    CHECK((Tether(6.0, 0.0).acceleration(start.x) - Spring(6.0).acceleration(start.x)).norm() == 0);
}
