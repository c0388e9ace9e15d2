#pragma once
/// \file
/// One check: whose answer is called, what was called, and how it ended.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "finding.hpp"
#include "registry.hpp"

namespace checker {

/// One call of the learner's function: its arguments, what it returned, and was that the right answer?
struct Call {
    Numbers arguments, result;
    bool right = true;
};

/// What a check has found.
struct Verdict : Finding {
    Kind kind = Kind::pass;
};

/// The check that is going on. There is one at a time, because Catch2's tests are global.
class Session {
public:
    /// Checks `answer` by the properties of `exercise`, with inputs drawn from `seed`.
    Verdict check(const std::string& exercise, const Answer& answer, std::uint64_t seed);

    /// Calls the answer under check. Throws NoAnswer where it gives none, or one that is not finite.
    Numbers call(const Numbers& arguments, const Spoken& spoken);
    /// What is wrong was seen at the last call: that is shown, whatever is called behind it.
    void show_last();
    /// A property has been looked at; `holds` it?
    void looked_at(const std::string& property, bool holds);

    std::uint64_t seed() const { return seed_; }
    /// Of what the draws are: 0 decides; another looks for a simpler case of what has failed.
    unsigned stream() const { return search_ ? search_->stream : 0; }

    /// How far off a property's numbers may be, where the task asks for no more than nine digits of an answer: a
    /// property may compute with a few answers.
    double near_enough() const { return within_.of_arguments > 0 ? 4 * within_.relative : 0; }

private:
    /// A property that is looked at once more, in another stream of draws, and what was called there.
    struct Search {
        Answer answer;
        unsigned stream = 0;
        std::size_t most = 0;  // calls
        std::vector<Call> calls;
        std::optional<Call> doubted;
        bool holds = true, is_over = false;
    };
    int run(const std::string& properties) const;
    Search searched(const std::string& property, const Answer& answer, unsigned stream, std::size_t most);
    Numbers call_in_search(const Numbers& arguments, const Spoken& spoken);
    void shrink(const std::string& property);
    double effort_of(const Call& call) const;
    void tell_call();
    Digits digits_for(const Call& call) const;

    Answer answer_;
    std::uint64_t seed_ = 0;
    std::string exercise_;
    std::vector<Call> calls_;
    std::size_t kept_ = 0;  // numbers, in them
    std::optional<Search> search_;
    const Spoken* spoken_ = nullptr;
    Truth truth_;
    Within within_{many_are_right};
    Call last_;                                // before the first property broke
    std::optional<Call> first_wrong_, shown_;  // the first wrong answer of all, and of the property in hand
    std::optional<Call> doubted_;              // where only the property itself knows what is wrong
    std::string first_wrong_in_;               // the property that called for it
    std::optional<NoAnswer> no_answer_;        // no use in calling again
    bool is_too_late_ = false;                 // to be too slow: before, a property has failed
    Verdict verdict_;
};

Session& session();

/// Is every number finite?
bool is_finite(const Numbers& numbers);
/// How many numbers of more than four digits stand in a text.
std::size_t long_numbers(const std::string& text);

/// The mistake, the slips or the region that the answer is wrong by wherever it is wrong; nothing where none fits, or
/// where two that differ do. (diagnose.cpp)
Diagnosis diagnose(const std::string& exercise, const Truth& truth, const std::vector<Call>& calls);

}  // namespace checker
