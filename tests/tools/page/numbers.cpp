// How numbers are set.
#include "number.hpp"

#include <catch2/catch_test_macros.hpp>

using page::typeset;
using page::typeset_tex;

TEST_CASE("a plain number is set as it is, with a proper minus") {
    CHECK(typeset("1.005", "") == "1.005");
    CHECK(typeset("-0.5", "") == "\u22120.5");
    CHECK(typeset("inf", "") == "\u221e");
    CHECK(typeset("-inf", "") == "\u2212\u221e");
}

TEST_CASE("scientific notation becomes a power of ten") {
    CHECK(typeset("-3.2e-16", "") == "\u22123.2\u202f×\u202f10<sup>\u221216</sup>");
    CHECK(typeset("6.02E+23", "") == "6.02\u202f×\u202f10<sup>23</sup>");
    CHECK(typeset("1e-06", "") == "10<sup>\u22126</sup>");
    CHECK(typeset("3e+00", "") == "3");
    CHECK(typeset("1e-400", "") == "10<sup>\u2212400</sup>");  // smaller than any double
}

TEST_CASE("long whole parts are grouped in threes, four digits are not") {
    CHECK(typeset("1000", "") == "1000");
    CHECK(typeset("12345", "") == "12\u202f345");
    CHECK(typeset("1234567.25", "") == "1\u202f234\u202f567.25");
}

TEST_CASE("a unit stands behind a narrow no-break space, its powers raised") {
    CHECK(typeset("9.81", "m/s^2") == "9.81\u202fm/s<sup>2</sup>");
    CHECK(typeset("2", "s^-1") == "2\u202fs<sup>\u22121</sup>");
    CHECK(typeset("5", "%") == "5\u202f%");
}

TEST_CASE("words are no numbers, and Markdown in them is shown") {
    CHECK(typeset("RK4_x <b>", "") == "RK4\\_x \\<b\\>");
    CHECK_FALSE(page::parse_number("nan"));
    CHECK_FALSE(page::parse_number("1.5 m"));
    CHECK_FALSE(page::parse_number(""));
}

TEST_CASE("in a formula the same number is TeX") {
    CHECK(typeset_tex("-3.2e-16", "m") == "-3.2\\times 10^{-16}\\,\\mathrm{m}");
    CHECK(typeset_tex("1e-06", "") == "10^{-6}");
    CHECK(typeset_tex("RK4", "") == "\\text{RK4}");
}
