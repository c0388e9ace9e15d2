// The claims of chapter 2 about several bodies in one state, one solver for all scenes, and
// problems that have no simple answer.

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <timestep/first_order_form.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "dual.hpp"
#include "extrapolation.hpp"

using namespace timestep;
using test_support::Dual;
using test_support::extrapolated;

namespace {

using Vector2 = Eigen::Vector2d;
using Vector4 = Eigen::Vector4d;
template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

}  // namespace

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
    const FirstOrderForm form{scene};

    // One second in 60 steps: the error that the chapter shows. Its reference takes 64 times as
    // many.
    const State<Vector2> shown = run(runge_kutta_4, scene, start, 1.0 / 60, 60);
    const State<Vector2> reference = run(runge_kutta_4, scene, start, 1.0 / 60 / 64, 60 * 64);
    const Vector4 second = extrapolated(form, stacked(start).y, 0.0, 0.05, 20);
    const double error = (stacked(shown).y - stacked(reference).y).norm();
    const double apart = (second - stacked(reference).y).norm();
    CHECK(error > 0);
    CHECK(apart < error / 100);

    // Straight up and down there is an exact answer: v = −v_t tanh(g t / v_t), fallen from rest.
    const Scene fall{Projectile(-9.81), Drag<double>::from_terminal_speed(40, 9.81)};
    const State end = run(runge_kutta_4, fall, State{0, 0.0, 0.0}, 1.0 / 256, 5 * 256);
    CHECK(std::fabs(end.v + 40 * std::tanh(9.81 * 5 / 40)) < 1e-9);
    CHECK(std::fabs(end.x + 40 * 40 / 9.81 * std::log(std::cosh(9.81 * 5 / 40))) < 1e-9);
    // It falls no faster than the terminal speed, and comes close to it.
    const State later = run(runge_kutta_4, fall, State{0, 0.0, 0.0}, 1.0 / 64, 60 * 64);
    CHECK(std::fabs(later.v + 40) < 1e-9);
}
