#pragma once
/// \file
/// The process that holds the learner's code.

#include "answer.hpp"

namespace checker {

/// Answers calls from `calls_fd` on `answers_fd` until there are no more. Where the learner's code
/// crashes, the last words are the addresses that lead to the line.
int serve(const Answer& answer);

}  // namespace checker
