// The references of chapter 7's flights, against others that share nothing with them.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>

#include <timestep/first_order_form.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/scene.hpp>

#include "contest/scenes.hpp"
#include "extrapolation.hpp"

using namespace contest;

namespace {

using Real = long double;

auto air(double terminal_speed) {
    return timestep::Drag<Real>(timestep::Drag<double>::from_terminal_speed(terminal_speed, 9.81).k);
}

}  // namespace

// Extrapolation in long double: with 32 steps between marks its error of order 16 is far below
// roundoff, of which the reference has half an ε of a place of up to 60 m when it is written down
// as a double.
TEST_CASE("the flight through air is known as well as a double can say it", "[N61][ch7]") {
    const Scene scene = drag();
    const timestep::FirstOrderForm form(
        timestep::Scene{timestep::Projectile(Eigen::Matrix<Real, 2, 1>(0, -9.81)), air(20)});
    Eigen::Matrix<Real, 4, 1> y(0, 0, 15, 20);
    const Real h = Real(duration) / marks;
    double furthest = 0;
    for (int mark = 0; mark < marks; ++mark) {
        y = test_support::extrapolated(form, y, Real(0), h / 32, 32);
        furthest = std::max(furthest, distance(scene, {double(y(0)), double(y(1))}, scene.reference[mark]));
    }
    CHECK(furthest <= scene.reference_error);
    CHECK(scene.reference_error < 1e-14);
    CHECK(scene.reference_error > 0);
}

// Runge-Kutta 4 in long double; the step that ends on the ground is found by bisection. What it
// does worst is the step over the top, where the drag k v² turns round: there v ≈ −gτ, the drag is
// kg² τ|τ|, and Simpson's rule misses the integral of τ|τ| by up to 0.011 h³. So wrong is the
// velocity then, and four seconds times that the height. The rest is roundoff, of a height of up to
// 5 m.
TEST_CASE("the ball's bounces are where another way finds them, five, and none at a mark", "[N61][ch7]") {
    const Scene scene = bouncing_ball();
    const timestep::Scene model{timestep::Projectile(-Real(9.81)), air(8)};
    const auto stepped = [&](const timestep::State<Real>& s, Real h) {
        return timestep::runge_kutta_4.step(model, s, h);
    };
    timestep::State<Real> ball{0, 5, 0};
    std::vector<double> bounces;
    const int steps = 4096;  // from mark to mark
    const Real h = Real(duration) / marks / steps;
    const Real bound =
        0.011L * air(8).k * 9.81L * 9.81L * h * h * h * duration + 5 * std::numeric_limits<double>::epsilon();
    for (int mark = 0; mark < marks; ++mark) {
        for (int i = 0; i < steps; ++i) {
            timestep::State<Real> next = stepped(ball, h);
            if (next.x < 0) {
                Real before = 0, after = h;
                for (int k = 0; k < 64; ++k) {
                    const Real middle = (before + after) / 2;
                    (stepped(ball, middle).x < 0 ? after : before) = middle;
                }
                next = stepped(ball, before);
                bounces.push_back(double(next.t));
                next = stepped({next.t, 0, -Real(0.8) * next.v}, h - before);
            }
            ball = next;
        }
        CAPTURE(mark);
        CHECK(std::fabs(double(ball.x) - scene.reference[mark][0]) < double(bound));
    }
    CHECK(bounces.size() == 5);
    for (const double t : bounces) {
        const double at = t / (duration / marks);
        CHECK(std::fabs(at - std::round(at)) * duration / marks > 0.02);
    }
}
