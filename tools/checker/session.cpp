#include "session.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <exception>

#include <catch2/catch_session.hpp>
#include <catch2/interfaces/catch_interfaces_capture.hpp>

#include "exercise.hpp"
#include "evidence.hpp"
#include "last_comparison.hpp"
#include "slips.hpp"

namespace checker {

const char* name_of(Kind kind) {
    static constexpr std::array names{"pass",     "not_started",     "wrong",      "not_finite",  "crash",
                                      "too_slow", "too_much_memory", "left_early", "course_error"};
    return names[static_cast<std::size_t>(kind)];
}

Session& session() {
    static Session one;
    return one;
}

namespace {

Catch::Session& catch2() {
    static Catch::Session one;
    return one;
}

}  // namespace

bool is_finite(const Numbers& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

int Session::run(const std::string& properties) const {
    Catch::ConfigData config;
    config.testsOrTags = {properties};
    config.reporterSpecifications = {Catch::ReporterSpec("verdict", {}, {}, {})};
    config.warnings = Catch::WarnAbout::NoAssertions;
    catch2().useConfigData(config);
    return catch2().run();
}

Verdict Session::check(const std::string& exercise, const Answer& answer, std::uint64_t seed) {
    exercise_ = exercise;
    answer_ = answer;
    seed_ = seed;
    search_.reset();
    calls_.clear();
    kept_ = 0;
    const Registered& known = registered(exercise);
    truth_ = known.truth;
    within_ = known.within;
    within_.ways = &known.slips;
    first_wrong_.reset();
    shown_.reset();
    doubted_.reset();
    no_answer_.reset();
    is_too_late_ = false;
    verdict_ = {};
    last_ = {};
    spoken_ = nullptr;
    begin_comparisons();

    const int failures = run("[" + exercise + "]");
    if (verdict_.property.empty() && failures != 0) {
        verdict_.kind = Kind::course_error;
        verdict_.detail = "there are no tests for '" + exercise + "'";
    }
    if (no_answer_ && verdict_.kind != Kind::pass && !is_too_late_) {
        verdict_.kind = no_answer_->kind;
        (no_answer_->kind == Kind::wrong ? verdict_.property : verdict_.detail) = no_answer_->what();
        verdict_.trace = no_answer_->trace;
        if (no_answer_->kind == Kind::wrong)
            calls_.clear(), shown_.reset(), doubted_.reset(), verdict_.detail.clear();  // which were not what is wrong
    }
    const bool all_hold = verdict_.kind == Kind::pass;
    if (all_hold && first_wrong_) {
        shown_ = first_wrong_;
        verdict_.kind = Kind::wrong;
        verdict_.property = "the answer is the right one wherever the task allows the arguments, to roundoff";
    }
    if (verdict_.kind == Kind::wrong || verdict_.kind == Kind::not_finite)
        verdict_.diagnosis = diagnose(exercise, truth_, calls_);
    const bool has_failed = (verdict_.kind == Kind::wrong && !no_answer_) || verdict_.kind == Kind::not_finite;
    if (has_failed && spoken_ && truth_.answer) shrink(all_hold ? first_wrong_in_ : verdict_.property);
    tell_call();
    if (verdict_.kind == Kind::wrong && !verdict_.right.empty()) verdict_.detail.clear();  // that says more
    return verdict_;
}

Numbers Session::call(const Numbers& arguments, const Spoken& spoken) {
    forget_comparison();
    if (search_) return call_in_search(arguments, spoken);
    if (no_answer_ && no_answer_->kind != Kind::not_finite) throw *no_answer_;
    spoken_ = &spoken;
    Numbers result;
    const auto end = [&](const NoAnswer& none) {
        no_answer_ = none;
        is_too_late_ = none.kind == Kind::too_slow && verdict_.kind != Kind::pass;
        if (!is_too_late_) last_ = {arguments, {}};
        throw none;
    };
    try {
        result = answer_(arguments);
    } catch (const NoAnswer& none) {
        end(none);
    } catch (const exercise::NotStarted&) {
        end(NoAnswer(Kind::not_started, ""));
    }
    if (!spoken.is_result(result)) end(NoAnswer(Kind::left_early, "The answer was not made as its type demands"));
    const Call made{arguments, result, is_finite(result) && is_right(truth_, arguments, result, within_, spoken)};
    kept_ += arguments.size() + result.size();
    if (calls_.size() < 100'000 && kept_ < 4'000'000) calls_.push_back(made);
    if (verdict_.kind == Kind::pass) {
        last_ = made;
        if (!made.right && !first_wrong_)
            first_wrong_ = made, first_wrong_in_ = Catch::getResultCapture().getCurrentTestName();
        if (!made.right && !shown_) shown_ = made;
    }
    if (!is_finite(result)) {
        if (!no_answer_ && verdict_.kind == Kind::pass) no_answer_ = NoAnswer(Kind::not_finite, "");
        throw NoAnswer(Kind::not_finite, "");
    }
    return result;
}

void Session::show_last() {
    if (search_ && !search_->doubted && !search_->calls.empty()) search_->doubted = search_->calls.back();
    if (!search_ && !doubted_) doubted_ = last_;
    keep_comparison();
}

// The properties after the first that breaks are looked at all the same: their calls help to tell
// one mistake from another.
void Session::looked_at(const std::string& property, bool holds) {
    if (search_) search_->holds = holds;
    if (!holds) keep_comparison();
    if (verdict_.kind != Kind::pass) return;
    if (holds) {
        shown_.reset();
        doubted_.reset();
        begin_comparisons();
        return;
    }
    verdict_.kind = Kind::wrong;
    verdict_.property = property;
    verdict_.detail = kept_comparison();
}

// Ten digits are read more easily. Do they lead whoever works the call out by hand to another answer?
Digits Session::digits_for(const Call& call) const {
    constexpr std::size_t by_hand = 10'000;  // numbers nobody works out, and to try them takes longer than the check
    if (call.arguments.size() > by_hand) return Digits::all;
    const auto in_ten = [](Numbers numbers) {
        for (double& number : numbers) number = std::strtod(written(number, Digits::ten).c_str(), nullptr);
        return numbers;
    };
    const Numbers shown = in_ten(call.arguments);
    if (same_bits(shown, call.arguments)) return Digits::ten;
    if (verdict_.kind == Kind::not_finite) return Digits::all;  // by hand it may well be finite
    try {
        return same_bits(in_ten(truth_.answer(shown)), in_ten(truth_.answer(call.arguments))) ? Digits::ten
                                                                                              : Digits::all;
    } catch (const std::exception&) {  // no arguments that the task allows
        return Digits::all;
    }
}

// The call that the learner is shown, and what it must return.
void Session::tell_call() {
    if (!spoken_) return;
    const bool is_wrong = verdict_.kind == Kind::wrong;
    const Call& call = is_wrong && shown_ ? *shown_ : is_wrong && doubted_ ? *doubted_ : last_;
    const bool told = is_wrong && shown_;
    // What is named is what the wrong call shows, or nothing is.
    if (told && !is_case_of(exercise_, truth_, verdict_.diagnosis, call)) verdict_.diagnosis = {};
    const Digits given = digits_for(call);
    verdict_.arguments = spoken_->arguments(call.arguments, given);
    if (call.result.empty()) return;
    const Numbers right = truth_.answer ? without_roundoff(truth_, call.arguments) : Numbers();
    // What is wrong is not to look right. (By less than that it is roundoff.)
    const bool differs = is_wrong && within_.relative != many_are_right && call.result.size() == right.size() &&
                         !std::equal(right.begin(), right.end(), call.result.begin(),
                                     [](double a, double b) { return std::fabs(a - b) <= 1e-13 * std::fabs(a); });
    const bool looks_right =
        differs && spoken_->result(call.result, right, Digits::ten) == spoken_->result(right, call.result, Digits::ten);
    const Digits digits = looks_right ? Digits::all : Digits::ten;
    // Whoever looks at the last digits of a result needs those of what it is made of.
    if (digits != given) verdict_.arguments = spoken_->arguments(call.arguments, Digits::all);
    verdict_.result = spoken_->result(call.result, told ? right : Numbers(), digits);
    if (told) verdict_.right = spoken_->result(right, call.result, digits);
}

}  // namespace checker
