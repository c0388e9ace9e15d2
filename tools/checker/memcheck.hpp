#pragma once
/// \file
/// What valgrind's memcheck writes of a worker.

#include <string>

namespace checker {

/// Throws NoAnswer where it has found something in the learner's code: the first of it.
void look_through(const std::string& log);

}  // namespace checker
