#pragma once
/// \file
/// What the hidden tests tell the course program, as both hold it. Through the pipe it goes as JSON (finding_json.hpp).

#include <cstdio>
#include <string>
#include <vector>

namespace checker {

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
inline constexpr const char *too_slow_asleep = "asleep", *too_slow_by_the_clock = "by the clock";

/// Stands in place of a call's arguments where all calls have been answered and the program ends.
inline constexpr const char* at_the_end = "at the end";

}  // namespace checker
