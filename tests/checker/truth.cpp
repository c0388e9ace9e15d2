// What decides whether an answer is the right one but for roundoff, and which mistake it is.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#include "numbers_eigen.hpp"
#include "diagnosed.hpp"
#include "slip.hpp"

namespace {

using namespace checker;

double velocity(double x0, double x1, double h) { return (x1 - x0) / h; }
double snaps(double x0, double x1, double h) { return std::fabs(x1 - x0) < 1e-9 ? 0 : (x1 - x0) / h; }
double backwards(double x0, double x1, double h) { return (x0 - x1) / h; }
double twice(double x0, double x1, double h) { return 2 * (x1 - x0) / h; }
double in_float(double x0, double x1, double h) { return float(x1 - x0) / float(h); }
double loses_digits(double x0, double x1, double h) { return (x1 - x0) / h * (1 + 1e-11); }
double off_by_a_thousandth(double x0, double x1, double h) { return (x1 - x0) / h * 1.001; }
double a_little_off(double x0, double x1, double h) { return (x1 - x0) / h * (1 + 1e-9 * std::cos(x1)); }
double off_by_a_fifth(double x0, double x1, double h) { return (x1 - x0) / h * 1.2; }
double logarithm(double x) { return std::log1p(x); }
double one_too_many(double x) { return std::log(1 + x); }
double sine(double angle) { return std::sin(angle); }
double forgets_h(double x0, double x1, double) { return x1 - x0; }
double sine_that_rounds(double angle) { return slip::sin(10, angle); }
double decrement(double first, double later, double periods) { return std::log(first / later) / periods; }
double root_first(double first, double later, double periods) { return std::log(std::pow(first / later, 1 / periods)); }
double root_first_that_rounds(double first, double later, double periods) {
    return slip::log(10, slip::pow(11, slip::over(12, first, later), slip::over(13, 1, periods)));
}
int whole(double share) { return static_cast<int>(std::floor(share)); }

using Function = double(double, double, double);

// Is that the right answer, where `truth` gives it?
template <class R, class... Args>
bool passes(R (*truth)(Args...), const Numbers& arguments, const Numbers& found, const Within& within = {2e-12}) {
    return is_right(function_of(truth), arguments, found, within, SpokenOf<R(Args...)>::spoken);
}
bool right(Function* function, const Numbers& arguments) {
    return passes(&velocity, arguments, answer_of(function)(arguments));
}

// Twenty calls as the hidden tests make them, and the name that they get.
std::string named(Function* function) {
    std::vector<Call> calls;
    for (int i = 1; i <= 20; ++i) {
        const Numbers arguments{1.0 * i, 0.3 * i * i, 0.1 * i};
        calls.push_back({arguments, answer_of(function)(arguments), right(function, arguments)});
    }
    return diagnosed("truth_test", function_of(&velocity), calls);
}

}  // namespace

TEST_CASE("a quaternion is shown as the tasks write it, with the cosine first") {
    Numbers numbers;
    Wire<Eigen::Quaterniond>::put(numbers, {0.5, 1, 2, 3});
    Reader reader(numbers);
    CHECK(Wire<Eigen::Quaterniond>::show(reader) == "Quaterniond(0.5, 1, 2, 3)");
}

TEST_CASE("what is wrong by more than roundoff is wrong, however near") {
    CHECK_FALSE(right(&snaps, {1, 1 + 1e-10, 0.7}));
    CHECK_FALSE(right(&snaps, {0, 1e-10, 0.7}));
    CHECK_FALSE(right(&backwards, {0, 1e-300, 0.7}));
}

TEST_CASE("a way that loses digits, and is right all the same, allows as many to be lost, and no more") {
    const auto allowed = [](double x, double found) {
        return passes(&logarithm, {x}, {found}, {2e-12, function_of(&one_too_many)});
    };
    for (double x = 1e-12; x < 1; x *= 1.3) {
        INFO(x);
        CHECK(allowed(x, std::log(1 + x)));
        CHECK(allowed(x, 2 * std::log(std::sqrt(1 + x))));
        CHECK_FALSE(allowed(x, std::log1p(x) * (1 + 4e-12) + 1e-14));
    }
}

TEST_CASE("another right way passes if it loses no more digits than the roundings of a known way cost") {
    const std::vector<Answer> ways{answer_of(&root_first_that_rounds)};
    const auto is_right_beside = [&](const Numbers& peaks, double found, const std::vector<Answer>* known) {
        return passes(&decrement, peaks, {found}, {2e-12, {}, 0, known});
    };
    for (double periods = 1; periods < 1e10; periods *= 7) {
        INFO(periods);
        const Numbers peaks{10, 5, periods};
        const double right = decrement(10, 5, periods), found = root_first(10, 5, periods);
        CHECK(is_right_beside(peaks, found, &ways));
        CHECK_FALSE(is_right_beside(peaks, right * (1 + 1e-11) + 1e-13, &ways));
        if (periods > 1e6) CHECK_FALSE(is_right_beside(peaks, found + 1e-15, nullptr));
    }
}

TEST_CASE("an angle may be moved by a part of a turn") {
    const std::vector<Answer> ways{answer_of(&sine_that_rounds)};
    const auto allowed = [&](double angle, double found) {
        return passes(&sine, {angle}, {found}, {2e-12, {}, 0, &ways});
    };
    for (const double angle : {0.0, 1e-300, 1e-12, 1e-3, 1.0, std::numbers::pi, 100.0}) {
        INFO(angle);
        CHECK(allowed(angle, std::cos(std::numbers::pi / 2 - angle)));
        CHECK(allowed(angle, -std::sin(angle - std::numbers::pi)));
        CHECK(allowed(angle, -std::cos(angle + std::numbers::pi / 2)));
        CHECK_FALSE(allowed(angle, std::sin(angle) + 1e-12 + 1e-10 * angle));
    }
}

TEST_CASE("nine digits are enough where the task asks for no more, but where the arguments cancel they must be right") {
    const Within nine{nine_digits, {}, all_digits};
    const auto allowed = [&](const Numbers& arguments, double share) {
        const double right = velocity(arguments[0], arguments[1], arguments[2]);
        return passes(&velocity, arguments, {right * (1 + share)}, nine);
    };
    CHECK(allowed({0, 1, 3}, 1.2e-9));  // 3.14159265 for pi
    CHECK_FALSE(allowed({0, 1, 3}, 1e-8));
    CHECK(allowed({1, 1 + 1e-6, 3}, 1.2e-9));
    CHECK_FALSE(allowed({1, 1 + 1e-6, 3}, 1e-4));
}

TEST_CASE("where roundoff decides on a whole number, either is right, and nowhere else") {
    CHECK(passes(&whole, {3.0}, {3}));
    CHECK(passes(&whole, {3.0}, {2}));
    CHECK_FALSE(passes(&whole, {3.0}, {5}));
    CHECK_FALSE(passes(&whole, {3.5}, {2}));
    CHECK_FALSE(passes(&whole, {3.001}, {2}));
}

TEST_CASE("a mistake is named where it answers as the learner does, and else by what it is always off") {
    static const bool known = register_mistakes("truth_test", {{"forgets_h", function_of(&forgets_h)}});
    CHECK(known);
    CHECK(named(&forgets_h) == "forgets_h");
    CHECK(named(&backwards) == "minus");
    CHECK(named(&twice) == "twice");
    CHECK(named([](double x0, double x1, double h) { return (x1 - x0) / h + x0 * x0; }).empty());
}

TEST_CASE("what is off by a little is single precision, a constant with few digits, or has lost some") {
    CHECK(named(&in_float) == "single");
    CHECK(named(&loses_digits) == "constant");
    CHECK(named(&off_by_a_thousandth) == "constant");
    CHECK(named(&a_little_off) == "digits");
    CHECK(named(&off_by_a_fifth) == "");
}

TEST_CASE("a mistake that loses digits has its name in another spelling, too, and only where as many are lost") {
    static const bool known = register_mistakes("digits_test", {{"lost", function_of(&one_too_many)}});
    CHECK(known);
    const auto name = [](double (*function)(double)) {
        std::vector<Call> calls;
        for (int i = 1; i <= 40; ++i) {
            const double x = 1e-9 * std::pow(1.7, i);
            const Numbers found = answer_of(function)({x});
            calls.push_back({{x}, found, passes(&logarithm, {x}, found)});
        }
        return diagnosed("digits_test", function_of(&logarithm), calls);
    };
    CHECK(name(&one_too_many) == "lost");
    CHECK(name(+[](double x) { return 2 * std::log(std::sqrt(1 + x)); }) == "lost");
    CHECK(name(+[](double x) { return -std::log(1 / (1 + x)); }) == "lost");
    CHECK(name(+[](double x) { return std::log1p(x) * (1 + 1e-3 * std::sin(1 / x)); }) == "digits");
    CHECK(name(+[](double x) { return double(float(std::log1p(float(x)))); }) == "single");
}

TEST_CASE("of long rows the place is shown where two differ, and a length that does") {
    using Rows = std::array<std::vector<int>, 2>;
    const auto spoken = [](const Rows& rows, const Rows& beside) {
        Numbers one, other;
        Wire<Rows>::put(one, rows);
        Wire<Rows>::put(other, beside);
        return SpokenOf<Rows(int)>::spoken.result(one, other, checker::Digits::ten);
    };
    Rows right{std::vector<int>(30), {1, 2}}, wrong = right;
    CHECK(spoken(right, right) == "{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, …, 0, 0}, {1, 2}}");
    wrong[0][17] = 4;
    CHECK(spoken(wrong, right) == "{{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, …, [17]: 4, …, 0, 0}, {1, 2}}");
    wrong = right;
    wrong[1].push_back(3);
    right[0].resize(2), wrong[0].resize(2);
    CHECK(spoken(wrong, right) == "{{0, 0}, {1, 2, 3} of length 3}");
}
