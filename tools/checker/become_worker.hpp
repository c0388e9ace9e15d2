#pragma once
/// \file
/// From a child of the checker to the program that holds a learner's code.

#include <string>
#include <vector>

#include <sys/types.h>

#include "remote.hpp"

namespace checker {

/// In the child: the pipes and the file in place of all that was open, limits, and the program with
/// an environment of its own. What keeps it from running is written to `failed`; what memcheck
/// finds goes to `found`.
[[noreturn]] void become_worker(const std::string& program, const std::vector<std::string>& launcher, pid_t parent,
                                int calls, int answers, int printed, int failed, int found, const Limits& limits);

}  // namespace checker
