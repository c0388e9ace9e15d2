// The models that are stiff: their derivatives, what they conserve, their exact solutions.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <Eigen/Core>

#include <timestep/models/prothero_robinson.hpp>
#include <timestep/models/robertson.hpp>
#include <timestep/models/van_der_pol.hpp>

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
