// What the text of an answer shows that is wrong.
#include <catch2/catch_test_macros.hpp>

#include <string>

#include "answer_lint.hpp"

using namespace course;

TEST_CASE("a quotient of whole numbers that leaves a rest is told with its line") {
    const std::string declared = "double zeta_from_swings(double first, double later, int swings)";
    for (const char* code : {"(x1 - x0) * (1/2)", "h + 1 / 2", "/* 3/4 */ 1// 5/6\n/2", "\"4\" + 1 / 2"})
        CHECK(divided_whole_numbers(code, declared).find("in C++ 1 / 2 is 0. What you may want is 1.0 / 2.") !=
              std::string::npos);
    CHECK(divided_whole_numbers("x;\ny = 1 / 2;", declared).starts_with("Line 2 divides whole numbers"));
    CHECK(divided_whole_numbers("1 / swings", declared).find("1 / swings has lost what is behind the point") !=
          std::string::npos);
}

TEST_CASE("no other quotient is") {
    const std::string declared = "double zeta_from_swings(double first, double later, int swings)";
    for (const char* code :
         {"4 / 2", "h + 1.0 / 2", ".5 / 2", "1e-1 / 2", "1 / 2.0", "h * 1 / 2", "1 / h", "x1 / 2", "2 / 1e3",
          "h // 1/2", "later / swings", "swings / 2", "double swings; 1 / swings", "1 / 0"})
        CHECK(divided_whole_numbers(code, declared).empty());
}

TEST_CASE("auto keeps an expression, but neither a lambda nor a list of names") {
    CHECK(keeps_by_auto("const auto L = inertia * spin;"));
    CHECK(keeps_by_auto("auto& L = inertia;"));
    CHECK_FALSE(keeps_by_auto("const auto rate = [&](double x) { return x; };"));
    CHECK_FALSE(keeps_by_auto("const auto [a, b] = pair;"));
    CHECK_FALSE(keeps_by_auto("for (const auto x : all) {} // auto y = x * 2;"));
}

TEST_CASE("a text of many letters is read") {
    CHECK_FALSE(keeps_by_auto("auto " + std::string(60'000, 'x')));
    CHECK(divided_whole_numbers(std::string(60'000, '1') + "/2", "").empty());
}
