#pragma once
/// \file
/// One check: whose answer is called, what was called, and how it ended.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "ended.hpp"

namespace checker {

/// One call of the learner's function: its arguments and what it returned.
struct Call {
    Numbers arguments, result;
};

/// A mistake that the course knows, and what it would have answered.
struct Mistake {
    std::string name;
    Answer answer;
};

/// What a check has found.
struct Verdict {
    Kind kind = Kind::pass;
    std::string property;       ///< the first that does not hold
    std::string misconception;  ///< the mistake that would have answered just so
    std::string detail;         ///< what is known of a crash and the like
    std::string trace;          ///< of a crash: the addresses that lead to it
    std::string arguments;      ///< of the call that it was noticed after: "(1, 2)"
    std::string result;         ///< what it returned, if it did
};

/// The check that is going on. There is one at a time, because Catch2's tests are global.
class Session {
public:
    /// Checks `answer` by the properties of `exercise`, with inputs drawn from `seed`.
    Verdict check(const std::string& exercise, const Answer& answer, std::uint64_t seed);

    /// Calls the answer under check. Throws Ended where it gives none, or one that is not finite.
    Numbers call(const Numbers& arguments, const Spoken& spoken);
    /// A property has been looked at; `holds` it?
    void looked_at(const std::string& property, bool holds);

    std::uint64_t seed() const { return seed_; }

private:
    std::string diagnose(const std::string& exercise, bool of_finite_answers) const;

    Answer answer_;
    std::uint64_t seed_ = 0;
    std::vector<Call> calls_;
    std::size_t kept_ = 0;  // numbers, in them
    const Spoken* spoken_ = nullptr;
    Call last_;                   // before the first property broke
    std::optional<Ended> ended_;  // no use in calling again
    Verdict verdict_;
};

Session& session();

/// The mistakes known of an exercise: filled before main.
bool know(const std::string& exercise, std::vector<Mistake> mistakes);
const std::vector<Mistake>& mistakes_of(const std::string& exercise);

}  // namespace checker
