// An answer that can slip: as written it is what it was; each slip is what it says; and the checker names it.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#include "diagnosed.hpp"
#include "slips.hpp"

namespace {

using namespace checker;
using slip::Form;

double landing(double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::sin(v); }

// As write_slips writes it.
double slipping(double x, double v, double h) {
    return x - slip::Minus{10} - h * slip::Times{11} * v / slip::Over{12} / 2 + slip::Plus{13} +
           h * slip::Times{14} * h / slip::Over{15} / 4 * slip::Times{16} * slip::sin(17, slip::pick(18, v, x, h));
}

std::vector<double> slipping_sums(const std::vector<double>& x) {
    std::vector<double> sum(x.size());
    for (std::size_t i = slip::from(10, 1); slip::turn() && (i < slip::Less{11} < x.size()); ++i)
        slip::in(sum)[i] = slip::in(sum)[i - slip::Minus{12} - 1] + slip::Plus{13} + slip::in(x)[i];
    return sum;
}
double endless(double) {
    while (slip::turn() && true) {
    }
    return 0;
}
bool both(double x, double v) { return slip::joined(10) ? x > 0 || v > 0 : x > 0 && v > 0; }
double mean(double x, double v, double) { return slip::unbracketed(10) ? x + v / 2 : (x + v) / 2; }

// Its last term twice, or x h half. Nothing that is given is changed by it, which would be a name of its own.
double with_quotient(double x, double v, double h) { return 7 + v * v / (x * h); }
double slipping_quotient(double x, double v, double h) {
    return 7 + slip::Plus{10} + v * slip::Times{11} * v / slip::Over{12} / (x * slip::Times{13} * h);
}

const Answer answer = answer_of(&slipping);
const bool known = register_slips("slips_test", {answer});

std::vector<Numbers> arguments() {
    std::vector<Numbers> all;
    for (int i = 1; i <= 20; ++i) all.push_back({1.5 * i, 0.3 * i * i, 0.1 * i});
    return all;
}

// The name that an answer gets.
std::string named(double (*learner)(double, double, double)) {
    std::vector<Call> calls;
    for (const Numbers& each : arguments()) {
        const double found = learner(each[0], each[1], each[2]);
        calls.push_back({each, {found}, std::fabs(found - landing(each[0], each[1], each[2])) < 1e-12});
    }
    return diagnosed("slips_test", function_of(&landing), calls);
}

}  // namespace

TEST_CASE("written so that it can slip, an answer is what it was") {
    for (const Numbers& each : arguments()) CHECK(answer(each) == Numbers{landing(each[0], each[1], each[2])});
}

TEST_CASE("a slip that leaves its vectors, or does not end, answers nothing") {
    const Answer vectors = answer_of(&slipping_sums);
    CHECK(slip::answered(vectors, {3, 1, 2, 3}, {11, 2, Form::edge}).empty());
    CHECK(slip::answered(vectors, {3, 1, 2, 3}, {10, 1, Form::loop}) == Numbers{3, 0, 0, 3});
    CHECK(slip::answered(answer_of(&endless), {1}, {10, 1, Form::sign}).empty());
    CHECK(slip::answered(vectors, {3, 1, 2, 3}, {10, 1, Form::loop}, nullptr, 3)
              .empty());  // it passes more places than that
}

TEST_CASE("brackets that are left out, and an or for an and, are slips, too") {
    CHECK(slip::answered(answer_of(&mean), {1, 4, 0}, {10, 1, Form::brackets}) == Numbers{3});
    CHECK(slip::answered(answer_of(&both), {1, -1}, {10, 1, Form::joined}) == Numbers{1});
}

TEST_CASE("an answer that does as a slip does is named by its kind") {
    CHECK(known);
    CHECK(named([](double x, double v, double h) { return x + h * v / 2 + h * h / 4 * std::sin(v); }) == "slip_sign");
    CHECK(named([](double x, double v, double h) { return x - h * v + h * h / 4 * std::sin(v); }) == "slip_twice");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 8 * std::sin(v); }) == "slip_half");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2; }) == "slip_term");
    CHECK(named([](double x, double v, double h) { return x - v / 2 + h * h / 4 * std::sin(v); }) == "slip_factor");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::cos(v); }) ==
          "slip_function");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::sin(x); }) ==
          "slip_variable");
    CHECK(named([](double x, double v, double h) {
              return x - h * v / 2 + h * h / 4 * std::sin(v * 180 / std::numbers::pi);
          }) == "slip_degrees");
}

TEST_CASE("where one part twice as large and another half as large do the same, neither is told") {
    static const bool knows = register_slips("tie_test", {answer_of(&slipping_quotient)});
    CHECK(knows);
    const auto name = [](double (*learner)(double, double, double)) {
        std::vector<Call> calls;
        for (const Numbers& each : arguments()) calls.push_back({each, {learner(each[0], each[1], each[2])}, false});
        return diagnosed("tie_test", function_of(&with_quotient), calls);
    };
    CHECK(name([](double x, double v, double h) { return 7 + 2 * v * v / (x * h); }).empty());
    CHECK(name([](double x, double v, double h) { return 7 - v * v / (x * h); }) == "slip_sign");
}

TEST_CASE("two slips at once are named, and what is none is not") {
    CHECK(named([](double x, double v, double h) { return x + h * v / 2 + h * h / 8 * std::sin(v); }) ==
          "slip_sign_and_half");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 5 * std::sin(v); }).empty());
    CHECK(named([](double x, double v, double h) { return x * x - h * std::exp(-v); }).empty());
}

TEST_CASE("two slips are not told where the answer is nothing but what was given, or no number") {
    CHECK(named([](double x, double, double) { return x; }).empty());
    CHECK(named([](double, double, double) { return std::nan(""); }).empty());
}

TEST_CASE("a count that is off by one wherever it is wrong is told, whatever it is elsewhere") {
    const auto half = +[](int n) { return n / 2; };
    std::vector<Call> calls;
    for (int n = 0; n < 40; ++n) calls.push_back({{double(n)}, {double(n < 10 ? n / 2 : n / 2 + 1)}, n < 10});
    CHECK(diagnosed("count_test", function_of(half), calls) == "one_more");
    calls.back().result[0] += 1;
    CHECK(diagnosed("count_test", function_of(half), calls).empty());
}

TEST_CASE("a mistake is not told that would have shown where the answer is right") {
    static const bool knows =
        register_mistakes("denied_test", {{"at_most_ten", function_of(+[](double x) { return std::min(x, 10.0); })}});
    CHECK(knows);
    const auto with = [](double wrong_from) {
        std::vector<Call> calls;
        for (double x = 1; x <= 200; ++x) calls.push_back({{x}, {x > wrong_from ? 10.0 : x}, x <= wrong_from});
        return diagnosed("denied_test", function_of(+[](double x) { return x; }), calls);
    };
    CHECK(with(10) == "at_most_ten");
    CHECK(with(190) == "is_10");
}
