// Inputs are refused once, with one line that names the value and the rule it breaks.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <limits>

#include <Eigen/Core>
#include <timestep/checks.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>

using namespace timestep;
using Catch::Matchers::Message;

TEMPLATE_TEST_CASE("checks let good values through as they are", "[library]", float, double, long double) {
    using Limits = std::numeric_limits<TestType>;
    for (const TestType value : {Limits::denorm_min(), Limits::min(), TestType(1), Limits::max()}) {
        CHECK(positive("p", value) == value);
        CHECK(not_negative("p", value) == value);
        CHECK(finite("p", -value) == -value);
    }
    CHECK(not_negative("p", TestType(0)) == 0);
    CHECK(not_negative("p", -TestType(0)) == 0);
    CHECK(finite("p", TestType(0)) == 0);
}

TEMPLATE_TEST_CASE("checks refuse what breaks their rule", "[library]", float, double, long double) {
    const TestType inf = std::numeric_limits<TestType>::infinity();
    const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
    for (const TestType value : {nan, inf, -inf}) {
        CHECK_THROWS_AS(finite("p", value), std::invalid_argument);
        CHECK_THROWS_AS(positive("p", value), std::invalid_argument);
        CHECK_THROWS_AS(not_negative("p", value), std::invalid_argument);
    }
    CHECK_THROWS_AS(positive("p", TestType(0)), std::invalid_argument);
    CHECK_THROWS_AS(positive("p", -std::numeric_limits<TestType>::denorm_min()), std::invalid_argument);
    CHECK_THROWS_AS(not_negative("p", -std::numeric_limits<TestType>::denorm_min()), std::invalid_argument);
}

TEST_CASE("the message names the value and the rule", "[library]") {
    CHECK_THROWS_MATCHES(positive("mass", -2.5), std::invalid_argument,
                         Message("mass = -2.5: must be finite and greater than zero"));
    CHECK_THROWS_MATCHES(not_negative("omega", -1.0f), std::invalid_argument,
                         Message("omega = -1: must be finite and zero or more"));
    CHECK_THROWS_MATCHES(finite("x", std::numeric_limits<double>::infinity()), std::invalid_argument,
                         Message("x = inf: must be a finite number"));
}

TEST_CASE("a vector or a state is finite when all its numbers are", "[library]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    CHECK(is_finite(Eigen::Vector3d(1, 2, 3)));
    CHECK_FALSE(is_finite(Eigen::Vector3d(1, nan, 3)));
    CHECK(is_finite(State{0, 1.0, 2.0}));
    CHECK_FALSE(is_finite(State{nan, 1.0, 2.0}));
    CHECK_FALSE(is_finite(State{0, inf, 2.0}));
    CHECK_FALSE(is_finite(State{0, Eigen::Vector2d(1, 1), Eigen::Vector2d(inf, 1)}));
    CHECK(is_finite(FirstOrder{0, 1.0}));
    CHECK_FALSE(is_finite(FirstOrder{0, inf}));
    CHECK_THROWS_AS(Projectile(Eigen::Vector2d(0, nan)), std::invalid_argument);
}
