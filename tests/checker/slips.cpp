// An answer that can slip: as written it is what it was; each slip is what it says; and the checker names it.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#include "session.hpp"
#include "slips.hpp"

namespace {

using namespace checker;
using slip::Form, slip::Made;

double landing(double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::sin(v); }

// As write_slips writes it.
double slipping(double x, double v, double h) {
    return x - slip::Minus{10} - h * slip::Times{11} * v / slip::Over{12} / 2 + slip::Plus{13} +
           h * slip::Times{14} * h / slip::Over{15} / 4 * slip::Times{16} * slip::sin(17, slip::pick(18, v, x, h));
}

std::vector<double> sums(const std::vector<double>& x) {
    std::vector<double> sum(x.size());
    for (std::size_t i = 1; i < x.size(); ++i) sum[i] = sum[i - 1] + x[i];
    return sum;
}
std::vector<double> slipping_sums(const std::vector<double>& x) {
    std::vector<double> sum(x.size());
    for (std::size_t i = slip::from(10, 1); slip::turn() && (i < slip::Less{11} < x.size()); ++i)
        slip::in(sum)[i] = slip::in(sum)[i - slip::Minus{12} - 1] + slip::Plus{13} + slip::in(x)[i];
    return sum;
}
double endless(double) {
    while (slip::turn() && true) {}
    return 0;
}

const Answer answer = answer_of(&slipping);
const bool known = know_slips("slips_test", {answer}) && know_slips("sums_test", {answer_of(&slipping_sums)});

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
    return diagnose("slips_test", function_of(&landing), calls);
}

}  // namespace

TEST_CASE("written so that it can slip, an answer is what it was") {
    for (const Numbers& each : arguments()) CHECK(answer(each) == Numbers{landing(each[0], each[1], each[2])});
    CHECK(slipping_sums({1, 2, 3, 4}) == sums({1, 2, 3, 4}));
}

TEST_CASE("each place of an answer is noted once, and slips as often as it can") {
    std::vector<Made> slips;
    for (const Numbers& each : arguments()) slip::note(answer, each, slips);
    for (const Made& made : slips) {
        INFO(made.site << " " << made.number << " " << slip::name_of(made.form));
        CHECK(std::count_if(slips.begin(), slips.end(), [&](const Made& other) { return other.site == made.site && other.number == made.number; }) == 1);
        bool differs = false;
        for (const Numbers& each : arguments()) differs |= slip::answered(answer, each, made) != answer(each);
        CHECK(differs);
    }
    CHECK(slips.size() > 40);
}

TEST_CASE("a slip that leaves its vectors, or does not end, answers nothing") {
    const Answer vectors = answer_of(&slipping_sums);
    CHECK(slip::answered(vectors, {3, 1, 2, 3}, {11, 2, Form::edge}).empty());
    CHECK(slip::answered(vectors, {3, 1, 2, 3}, {10, 1, Form::loop}) == Numbers{3, 0, 0, 3});
    CHECK(slip::answered(answer_of(&endless), {1}, {10, 1, Form::sign}).empty());
}

TEST_CASE("an answer that does as a slip does is named by its kind") {
    CHECK(known);
    CHECK(named([](double x, double v, double h) { return x + h * v / 2 + h * h / 4 * std::sin(v); }) == "slip_sign");
    CHECK(named([](double x, double v, double h) { return x - h * v + h * h / 4 * std::sin(v); }) == "slip_twice");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 8 * std::sin(v); }) == "slip_half");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2; }) == "slip_term");
    CHECK(named([](double x, double v, double h) { return x - v / 2 + h * h / 4 * std::sin(v); }) == "slip_factor");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::cos(v); }) == "slip_function");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::sin(x); }) == "slip_variable");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 4 * std::sin(v * 180 / std::numbers::pi); }) == "slip_degrees");
}

TEST_CASE("two slips at once are named, and what is none is not") {
    CHECK(named([](double x, double v, double h) { return x + h * v / 2 + h * h / 8 * std::sin(v); }) == "slip_sign_and_half");
    CHECK(named([](double x, double v, double h) { return x - h * v / 2 + h * h / 5 * std::sin(v); }).empty());
    CHECK(named([](double x, double v, double h) { return x * x - h * std::exp(-v); }).empty());
}

TEST_CASE("a slip that is off in one number of two is not named for what is off in both") {
    const auto two = +[](double x, double v) { return std::vector<double>{x, v}; };
    std::vector<Call> calls;
    for (double x = 1; x < 12; ++x) calls.push_back({{x, 1e-9 * x}, {2, 2 * x, 3e-9 * x}, false});
    static const bool knows = know("two_test", {{"first_twice", function_of(+[](double x, double v) { return std::vector<double>{2 * x, v}; })}});
    CHECK(knows);
    CHECK(diagnose("two_test", function_of(two), calls).empty());
}
