#pragma once
/// \file
/// How a check ends, and what the hidden tests tell the course program of it. Through the pipe that goes as JSON
/// (finding_json.hpp).

#include <stdexcept>
#include <string>
#include <vector>

namespace checker {

/// What a check finds. The names are what `./course check --json` says.
enum class Kind {
    pass,
    not_started,      ///< the file still says `not_started`
    wrong,            ///< a property does not hold; of NoAnswer: one that all functions have
    not_finite,       ///< an answer is NaN or infinite
    crash,            ///< a signal, or an exception that nobody caught
    too_slow,         ///< a call took more than it may
    too_much_memory,  ///< more than it may have
    left_early,       ///< the program ended, or spoke out of turn, instead of answering
    course_error      ///< the checker itself failed
};

/// `not_started` and so on.
const char* name_of(Kind kind);

/// Thrown by an Answer that gave none.
struct NoAnswer : std::runtime_error {
    NoAnswer(Kind kind, const std::string& what, const std::string& trace = {})
        : std::runtime_error(what), kind(kind), trace(trace) {}
    Kind kind;
    std::string trace;  ///< of a crash: the addresses that lead to it, from the inside out
};

/// Why an answer is wrong. Either a mistake, or one or two slips, or a region and a value, or nothing is known.
struct Diagnosis {
    std::string mistake = {};             ///< its name: of one that the exercise knows, or of a generic one
    std::vector<std::string> slips = {};  ///< their forms: "sign"
    std::string region =
        {};  ///< where it is wrong: "zero", "negative", "positive", "empty", "nonzero", "above", "below"
    std::size_t argument = 0;  ///< the number of the arguments that the region is of; lists count by their length
    std::string limit = {};    ///< of "above" and "below", as the learner reads it
    std::string value = {};    ///< what it always is there: "given", or a whole number

    bool empty() const { return mistake.empty() && slips.empty() && region.empty() && value.empty(); }
    bool operator==(const Diagnosis&) const = default;

    /// One word for it, as `./course check --json` prints: "middle", "slip_sign", "where_above_2_1.5_is_given".
    std::string label() const {
        std::string words = mistake;
        for (const std::string& slip : slips) words += (words.empty() ? "slip_" : "_and_") + slip;
        if (!region.empty()) words = "where_" + region + "_" + std::to_string(argument);
        if (!limit.empty()) words += "_" + limit;
        if (!value.empty()) words += (words.empty() ? "is_" : "_is_") + value;
        return words;
    }
};

/// What a check has found, beside its kind.
struct Finding {
    std::string property = {};   ///< the first that does not hold
    Diagnosis diagnosis = {};    ///< of a wrong answer
    std::string detail = {};     ///< what is known of a crash and the like, or both sides of the property
    std::string trace = {};      ///< of a crash: the addresses that lead to it
    std::string arguments = {};  ///< of the call that it was noticed after: "(1, 2)"
    std::string result = {};     ///< what it returned, if it did
    std::string right = {};      ///< what it must return, where that was something else
};

/// The detail of a too_slow where it was not work that took too long.
inline constexpr const char* too_slow_by_the_clock = "by the clock";

/// Stands in place of a call's arguments where all calls have been answered and the program ends.
inline constexpr const char* at_the_end = "at the end";

}  // namespace checker
