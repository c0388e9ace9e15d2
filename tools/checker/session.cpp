#include "session.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <catch2/catch_session.hpp>

#include "exercise.hpp"

namespace checker {

const char* name_of(Kind kind) {
    static constexpr std::array names{"pass",        "not_started", "wrong",           "not_finite",
                                      "crash",       "too_slow",    "too_much_memory", "left_early",
                                      "course_error"};
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

bool is_finite(const Numbers& numbers) {
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

// How far one answer lies from another, relative to the larger. Where both are NaN, or infinite
// alike, they agree.
double apart(const Numbers& a, const Numbers& b) {
    if (a.size() != b.size()) return HUGE_VAL;
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i]))) {
            size = std::isfinite(a[i]) ? std::max(size, std::fabs(a[i])) : size;
            continue;
        }
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return HUGE_VAL;
        difference = std::max(difference, std::fabs(a[i] - b[i]));
        size = std::max({size, std::fabs(a[i]), std::fabs(b[i])});
    }
    return difference == 0 ? 0 : difference / size;
}

}  // namespace

Verdict Session::check(const std::string& exercise, const Answer& answer, std::uint64_t seed) {
    answer_ = answer;
    seed_ = seed;
    calls_.clear();
    kept_ = 0;
    ended_.reset();
    verdict_ = {};
    last_ = {};
    spoken_ = nullptr;

    Catch::ConfigData config;
    config.testsOrTags = {"[" + exercise + "]"};
    config.reporterSpecifications = {Catch::ReporterSpec("verdict", {}, {}, {})};
    config.warnings = Catch::WarnAbout::NoAssertions;
    catch2().useConfigData(config);
    const int failures = catch2().run();
    if (verdict_.property.empty() && failures != 0) {
        verdict_.kind = Kind::course_error;
        verdict_.detail = "there are no tests for '" + exercise + "'";
    }
    if (ended_ && verdict_.kind != Kind::pass) {
        verdict_.kind = ended_->kind;
        (ended_->kind == Kind::wrong ? verdict_.property : verdict_.detail) = ended_->what();
        verdict_.trace = ended_->trace;
        if (ended_->kind == Kind::wrong) calls_.clear();  // which were not what is wrong
    }
    if (verdict_.kind == Kind::wrong || verdict_.kind == Kind::not_finite)
        verdict_.misconception = diagnose(exercise, false);
    // Answers that are not finite came after what is told, and are another fault.
    if (verdict_.kind == Kind::wrong && verdict_.misconception.empty())
        verdict_.misconception = diagnose(exercise, true);
    if (spoken_) {
        verdict_.arguments = spoken_->arguments(last_.arguments);
        if (!last_.result.empty()) verdict_.result = spoken_->result(last_.result);
    }
    return verdict_;
}

Numbers Session::call(const Numbers& arguments, const Spoken& spoken) {
    if (ended_ && ended_->kind != Kind::not_finite) throw *ended_;
    spoken_ = &spoken;
    Numbers result;
    const auto end = [&](const Ended& ended) {
        ended_ = ended;
        last_ = {arguments, {}};
        throw ended;
    };
    try {
        result = answer_(arguments);
    } catch (const Ended& ended) {
        end(ended);
    } catch (const exercise::NotStarted&) {
        end(Ended(Kind::not_started, ""));
    }
    if (!spoken.is_result(result))
        end(Ended(Kind::left_early, "The answer was not made as its type demands"));
    kept_ += arguments.size() + result.size();
    if (calls_.size() < 100'000 && kept_ < 4'000'000) calls_.push_back({arguments, result});
    if (verdict_.kind == Kind::pass) last_ = {arguments, result};
    if (!is_finite(result)) {
        if (!ended_ && verdict_.kind == Kind::pass) ended_ = Ended(Kind::not_finite, "");
        throw Ended(Kind::not_finite, "");
    }
    return result;
}

// The properties after the first that breaks are looked at all the same: their calls help to tell
// one mistake from another.
void Session::looked_at(const std::string& property, bool holds) {
    if (holds || verdict_.kind != Kind::pass) return;
    verdict_.kind = Kind::wrong;
    verdict_.property = property;
}

// The known mistake that would have answered every call just so, or every one with a finite answer. What roundoff does to two ways of
// writing the same mistake, single precision included, is far below 1e-4.
std::string Session::diagnose(const std::string& exercise, bool of_finite_answers) const {
    std::string nearest;
    double least = 1e-4;
    for (const Mistake& mistake : mistakes_of(exercise)) {
        double worst = 0;
        for (const Call& call : calls_) {
            if (of_finite_answers && !is_finite(call.result)) continue;
            worst = std::max(worst, apart(call.result, mistake.answer(call.arguments)));
            if (worst >= least) break;
        }
        if (worst < least) {
            least = worst;
            nearest = mistake.name;
        }
    }
    return nearest;
}

}  // namespace checker
