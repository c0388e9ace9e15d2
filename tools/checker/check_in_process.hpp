#pragma once
/// \file
/// A check without the course program, for Windows: the answer is linked with the hidden tests and runs in their
/// process. It is not shut away, nothing ends it, and where it crashes there is no verdict.

#include <string>

#include "answer.hpp"

namespace checker {

/// Checks the answer with inputs drawn anew, or from the seed in `words[1]`, and tells what `./course check` would.
/// Returns the exit status: 0 when the answer is right, 1 when it is not, 2 for wrong use.
int check_in_process(const std::string& exercise, const Answer& answer, int count, char** words);

}  // namespace checker
