// The library's own cube root, sine and cosine, beside those of long double.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <random>

#include <timestep/own_math.hpp>

using namespace timestep;

namespace {

// Sine and cosine of a quarter turn and less, which every mathematical library knows. Mingw's take the x87's π for
// larger angles, which has 66 bits: so whole quarters are taken off here, π/2 in three parts.
void long_sine_cosine(long double x, long double& sine, long double& cosine) {
    const long double quarters = std::round(x / 1.57079632679489661923L);
    const long double rest =
        x - quarters * 0xc90fdaa221p-39L - quarters * 0x68c234c4c6p-79L - quarters * 0xc51701b839a2520p-140L;
    const long double s = std::sin(rest), c = std::cos(rest);
    const int quarter = int(std::fmod(quarters, 4.0L) + 4) % 4;
    sine = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    cosine = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
}

}  // namespace

// Bounds in roundoffs, ε/2. A sum of n terms of which the first is the largest is off by the half roundoff of the last
// addition, and little more: one roundoff for s and c, and for the reduced angle one more.
TEMPLATE_TEST_CASE("own sine and cosine are off by a roundoff of 1, or of the angle", "[own_math]", float, double) {
    const long double roundoff = std::numeric_limits<TestType>::epsilon() / 2;
    std::mt19937_64 numbers(1);
    std::uniform_real_distribution<double> even(-1, 1);
    for (int i = 0; i < 200000; ++i) {
        const double size = i % 4 == 0 ? 0.7 : i % 4 == 1 ? 20 : i % 4 == 2 ? 500000 : 1e15;
        const auto x = TestType(size * even(numbers));
        const auto [sine, cosine] = sine_cosine(x);
        const long double size_of_x = std::fabs((long double)x),
                          allowed = 2 * roundoff * (size_of_x > 500000 ? size_of_x : 1);
        long double right_sine, right_cosine;
        long_sine_cosine(x, right_sine, right_cosine);
        INFO("x = " << x);
        REQUIRE(std::fabs(sine - right_sine) <= allowed);
        REQUIRE(std::fabs(cosine - right_cosine) <= allowed);
    }
}

TEMPLATE_TEST_CASE("own cube root is off by a roundoff, at all sizes", "[own_math]", float, double) {
    const long double epsilon = std::numeric_limits<TestType>::epsilon();
    std::mt19937_64 numbers(2);
    std::uniform_real_distribution<double> even(-1, 1);
    using Limits = std::numeric_limits<TestType>;
    for (int i = 0; i < 200000; ++i) {
        const auto x = TestType(std::ldexp(even(numbers), int((Limits::max_exponent - 1) * even(numbers))));
        const long double right = std::cbrt((long double)x);
        INFO("x = " << x);
        REQUIRE(std::fabs(cube_root(x) - right) <= epsilon * std::fabs(right));
    }
    for (const TestType x : {Limits::denorm_min(), Limits::max(), -Limits::min()}) {
        const long double right = std::cbrt((long double)x);
        REQUIRE(std::fabs(cube_root(x) - right) <= epsilon * std::fabs(right));
    }
}

TEMPLATE_TEST_CASE("own functions of zero, infinity and no number", "[own_math]", float, double) {
    const TestType infinity = std::numeric_limits<TestType>::infinity(),
                   none = std::numeric_limits<TestType>::quiet_NaN();
    CHECK(sine_cosine(TestType(0)).sine == 0);
    CHECK(sine_cosine(TestType(0)).cosine == 1);
    CHECK(std::signbit(cube_root(-TestType(0))));
    CHECK(cube_root(-infinity) == -infinity);
    CHECK(cube_root(TestType(-27)) == -3);
    CHECK(std::isnan(cube_root(none)));
    for (const TestType x : {infinity, -infinity, none}) {
        CHECK(std::isnan(sine_cosine(x).sine));
        CHECK(std::isnan(sine_cosine(x).cosine));
    }
}
