#pragma once
/// \file
/// Running a program that may not come to an end by itself.

#include <cstddef>
#include <string>
#include <vector>

namespace course {

/// How much a program may take.
struct Allowance {
    double seconds;
    std::size_t megabytes;  ///< of memory; 0: as much as it likes
};

struct Outcome {
    int status = 0;         ///< its exit status; 128 + signal where one ended it
    bool too_slow = false;  ///< it was stopped
    std::string said;       ///< standard output and error together, the first million bytes
};

/// Runs `command` to its end or to the end of its allowance, and then ends the whole process group.
Outcome run_within(const std::vector<std::string>& command, const Allowance& allowance);

}  // namespace course
