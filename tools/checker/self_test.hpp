#pragma once
/// \file
/// The answers that the tests of an exercise are tested with.

#include <string>
#include <utility>
#include <vector>

#include "session.hpp"

namespace checker {

/// Beside the mistakes, which the learner's tests know too.
struct Variants {
    Answer stub;
    std::vector<std::pair<std::string, Answer>> correct;  ///< the solution, and others written differently
};

/// Filled before main.
bool register_variants(const std::string& exercise, const Answer& stub, const Answer& solution,
                       std::vector<std::pair<std::string, Answer>> correct);
const Variants& variants_of(const std::string& exercise);

}  // namespace checker
