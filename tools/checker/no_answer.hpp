#pragma once
/// \file
/// How a check can end.

#include <stdexcept>
#include <string>

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

}  // namespace checker
