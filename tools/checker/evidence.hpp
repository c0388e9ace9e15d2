#pragma once
/// \file
/// The calls of a check that tell one mistake from another.

#include <optional>
#include <string>
#include <vector>

#include "session.hpp"

namespace checker {

/// Calls whose answers were wrong, what was right there, and calls whose answers were right.
struct Evidence {
    std::vector<const Call*> wrong, right;
    std::vector<Numbers> truth;     ///< of each of the wrong ones
    std::vector<Numbers> roundoff;  ///< what that of the arguments makes of each number of these
    std::vector<double> beside{};   ///< of each of the right ones: so far from it another may be that is as right; none
                                    ///< where one alone is
    bool tells_little = false;  ///< what is wrong is mostly a zero, or a number that was given: many mistakes end there
};

inline constexpr std::size_t enough_calls = 2000;  ///< are looked at, of the wrong ones and of the right ones

/// Is the call a case of what is diagnosed? The call that the learner is shown must be one.
/// (diagnose.cpp)
bool is_case_of(const std::string& exercise, const Truth& truth, const Diagnosis& diagnosis, const Call& call);

/// The size of the largest number that is finite.
double size_of(const Numbers& numbers);
/// How far one answer lies from another. What is not finite agrees with its like. (diagnose.cpp)
double apart(const Numbers& a, const Numbers& b);
/// Does `made` err as the learner does, who found `found` where `right` is right? Number by number, for one number off
/// by much must not hide another: to a thousandth of what is wrong there, which is more than another way to write the
/// same mistake makes of it, and to roundoff.
bool errs_alike(const Numbers& made, const Numbers& found, const Numbers& right, const Numbers& roundoff);
/// By how much `way` misses the right answer where the arguments are smaller by shares of at most `most`, number by
/// number.
Numbers lost_within(double most, const Function& way, const Truth& truth, const Numbers& arguments, unsigned variation);
/// Are they one but for roundoff?
bool is_same(const Numbers& made, const Numbers& found);

/// The forms of the slip that answers as the learner does; none where no slip does. `counted`: of a yes and a no, or of
/// counts, many agree by chance. Nothing at all where two slips do that say the opposite. (slips/diagnose_slip.cpp)
std::optional<std::vector<std::string>> slips_of(const std::string& exercise, const Evidence& evidence, bool counted);
/// The forms of two slips at once.
std::vector<std::string> two_slips_of(const std::string& exercise, const Evidence& evidence);
/// `one`: a call as often as if it were all that are wrong.
bool is_case_of_slips(const std::string& exercise, const std::vector<std::string>& forms, const Evidence& one);

/// Is the answer wrong only where one of the arguments is zero, negative or positive, or a list is empty, and is it
/// there always what was given, or one whole number? Nothing where neither is so.
Diagnosis wrong_region(const Truth& truth, const std::vector<Call>& calls, const Evidence& evidence);
bool is_case_of_region(const Diagnosis& diagnosis, const Truth& truth, const Call& call);
/// Of counts, and of yes and no: is it wrong only where a little less of the arguments makes another of the right
/// answer? (wrong_region.cpp)
bool is_near_thing(const Truth& truth, const Evidence& evidence);

/// By what is the answer off, in nearly every call: "twice", "minus".
std::string generic_mistake_of(const Evidence& evidence);
/// Is it no where it should be yes, and yes where it should be no, in every call?
bool is_negated(const std::vector<Call>& calls, const Evidence& evidence);
/// Is a count off by one, and always to one side, wherever it is wrong?
std::string off_by_one(const Evidence& evidence);
/// Mistakes that make the answer inexact, whatever the exercise.
std::string inexact(const Truth& truth, const Evidence& evidence);
/// Wherever it is wrong, is it what was given, changed twice as much as it should be, half, or the other way?
std::string changed(const Truth& truth, const Evidence& evidence);
bool is_case_of_generic_mistake(const std::string& name, const Truth& truth, const Evidence& one);
/// (generic_mistakes.cpp)

}  // namespace checker
