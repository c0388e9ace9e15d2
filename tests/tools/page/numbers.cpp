// How numbers are set.
#include "number.hpp"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("a number is set with a proper minus, powers of ten, groups of three digits and its unit") {
    const char* const cases[][4] = {
        // value, unit, in a sentence, in a formula
        {"1.005", "", "1.005", "1.005"},
        {"-inf", "", "\u2212\u221e", "-\\infty"},
        {"-3.2e-16", "m", "\u22123.2\u202f×\u202f10<sup>\u221216</sup>\u202fm", "-3.2\\times 10^{-16}\\,\\mathrm{m}"},
        {"6.02E+23", "", "6.02\u202f×\u202f10<sup>23</sup>", "6.02\\times 10^{23}"},
        {"1e-06", "", "10<sup>\u22126</sup>", "10^{-6}"},
        {"3e+00", "", "3", "3"},
        {"1e-400", "", "10<sup>\u2212400</sup>", "10^{-400}"},  // smaller than any double
        {"1000", "", "1000", "1000"},
        {"1234567.25", "", "1\u202f234\u202f567.25", "1\\,234\\,567.25"},
        {"2", "s^-1", "2\u202fs<sup>\u22121</sup>", "2\\,\\mathrm{s^-1}"},
        {"5", "%", "5\u202f%", "5\\,\\mathrm{%}"},
        // Words are no numbers, and Markdown in them is shown.
        {"RK4_x <b>", "", "RK4\\_x \\<b\\>", "\\text{RK4_x <b>}"},
        {"nan", "", "nan", "\\text{nan}"},
        {"1.5 m", "", "1.5 m", "\\text{1.5 m}"},
    };
    for (const auto& [value, unit, sentence, formula] : cases) {
        CHECK(page::typeset(value, unit) == sentence);
        CHECK(page::typeset_tex(value, unit) == formula);
    }
}
