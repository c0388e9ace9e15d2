// The models that are stiff: their derivatives, what they conserve, their exact solutions. (That stability functions
// are what steps multiply by, chapter 6's study checks.)
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <timestep/models/complex_decay.hpp>
#include <timestep/models/prothero_robinson.hpp>
#include <timestep/models/robertson.hpp>
#include <timestep/models/van_der_pol.hpp>
#include <timestep/stability_function.hpp>

using namespace timestep;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Central differences: exact for polynomials of degree two, apart from roundoff of about ε |f| / d.
template <class System, class Y>
auto differences(const System& f, const Y& at, const Y& d) {
    decltype(f.slope_y(0.0, at)) result;
    for (int j = 0; j < at.size(); ++j) {
        Y less = at, more = at;
        less(j) -= d(j), more(j) += d(j);
        result.col(j) = (f(0.0, more) - f(0.0, less)) / (more(j) - less(j));
    }
    return result;
}

}  // namespace

TEST_CASE("Van der Pol's rate and its derivatives", "[library]") {
    const VanDerPol<double> f(1e6);
    const Eigen::Vector2d y(1.5, -0.25);
    // μ ((1 − 2.25)(−0.25) − 1.5) = −1.1875 μ
    CHECK(f(0, y) == Eigen::Vector2d(-0.25, -1.1875e6));
    const Eigen::Vector2d d(0.25, 0.25);
    CHECK((f.slope_y(0, y) - differences(f, y, d)).norm() < 20 * eps * 2e6 / 0.25);
    CHECK_THROWS_AS(VanDerPol(0.0), std::invalid_argument);
    CHECK_THROWS_AS(VanDerPol(std::nan("")), std::invalid_argument);
}

TEST_CASE("Robertson's rates, their derivatives, and a sum that stays", "[library]") {
    const Robertson<double> f;
    // At y = (1, 0, 0) only the slow reaction goes.
    CHECK(f(0, {1, 0, 0}) == Eigen::Vector3d(-0.04, 0.04, 0));
    const Eigen::Vector3d y(0.7, 1e-5, 0.3);
    CHECK(std::fabs(f(0, y)(2) - 3e7 * 1e-10) < 4 * eps * 3e-3);
    const Eigen::Vector3d d(0.1, 1e-6, 0.1);
    // The terms of a rate are below 0.1, and the smallest d is 1e-6.
    CHECK((f.slope_y(0, y) - differences(f, y, d)).norm() < 20 * eps * 0.1 / 1e-6);
    // Nothing is lost: the rates add up to zero, and so does each column of the derivatives.
    CHECK(std::fabs(f(0, y).sum()) < 8 * eps * 0.1);
    CHECK(f.slope_y(0, y).colwise().sum().norm() < 8 * eps * 4e3);
}

TEST_CASE("Prothero and Robinson's exact solution solves its equation", "[library]") {
    for (const double lambda : {-3.0, 0.5}) {
        const ProtheroRobinson<double> f(lambda);
        const FirstOrder<double> start{0.3, 2.0};
        CHECK(f.exact(start, 0.0).y == 2.0);
        for (const double t : {0.1, 1.7}) {
            const double d = 1e-5;
            const double rate = (f.exact(start, t + d).y - f.exact(start, t - d).y) / (2 * d);
            const FirstOrder<double> now = f.exact(start, t);
            // d²/6 times a third derivative below 50, and ε/d.
            CHECK(std::fabs(rate - f(now.t, now.y)) < 50 * d * d / 6 + 20 * eps / d);
        }
    }
    CHECK(ProtheroRobinson(-1e6).slope_y(0, 1) == -1e6);
    // Who starts on the slow motion stays on it, and who starts off it is there at once.
    const ProtheroRobinson<double> stiff(-1e6);
    CHECK(std::fabs(stiff.exact({0, 1}, 2.0).y - std::cos(2.0)) < 4 * eps);
    CHECK(std::fabs(stiff.exact({0, 7}, 1e-3).y - std::cos(1e-3)) < 4 * eps);
    CHECK_THROWS_AS(ProtheroRobinson(std::nan("")), std::invalid_argument);
}

TEST_CASE("a complex decay turns and shrinks as e^(lambda t)", "[models]") {
    const ComplexDecay model(Complex(-0.5, 3.0));
    const FirstOrder<Eigen::Vector2d> start{1, {2, -1}};
    const FirstOrder<Eigen::Vector2d> later = model.exact(start, 0.7);
    CHECK(later.t == 1.7);
    // f is the derivative of the exact motion: a central difference is wrong by h²/6 |λ|³ |y|, some
    // 1e-9.
    const double h = 1e-5;
    const Eigen::Vector2d slope = (model.exact(start, 0.7 + h).y - model.exact(start, 0.7 - h).y) / (2 * h);
    CHECK((slope - model(0, later.y)).norm() < 1e-8);
    CHECK((model.slope_y(0, later.y) * later.y - model(0, later.y)).norm() < 8 * eps * 3.1 * 3);
    CHECK_THROWS_AS(ComplexDecay(Complex(NAN, 0)), std::invalid_argument);
    CHECK_THROWS_AS(ComplexDecay(Complex(0, INFINITY)), std::invalid_argument);
}

// Where z⁴ is too large for a number, |R| is infinite, and not a NaN that compares with nothing.
TEST_CASE("RK4 far out multiplies by more than any number", "[library]") {
    for (const double size : {1e78, 1e103, 1e150, 1e155, 1e200, 1e308})
        for (double angle = 0; angle < 6.3; angle += 0.1) {
            INFO("z = " << size << " e^(i " << angle << ")");
            CHECK(std::abs(stability_function(runge_kutta_4, std::polar(size, angle))) == INFINITY);
        }
    CHECK(std::abs(stability_function(runge_kutta_4, -1e103)) == INFINITY);
    CHECK(std::abs(stability_function(runge_kutta_4, Complex(0, 1e103))) == INFINITY);
    // And near by it is the series: its terms are 32/3 and less, rounded a few times each.
    const double z = -2, series = 1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24;
    CHECK(std::abs(stability_function(runge_kutta_4, z) - series) < 1e-15);
}
