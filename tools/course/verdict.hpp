#pragma once
/// \file
/// From a learner's file to a verdict: compile it, link it with its worker, and let the hidden tests call it.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "../checker/finding.hpp"
#include "exercises.hpp"
#include "stop.hpp"

namespace course {

class Sandbox;

/// What a check has found. `kind` is one of: pass, does_not_compile, not_started, wrong,
/// not_finite, crash, too_slow, too_much_memory, left_early, course_error.
struct Verdict : checker::Finding {
    std::string kind;
    std::string compiler;  ///< what the compiler said, warnings included
    std::string printed;   ///< what the learner's code printed, or a sanitizer's report
    std::string remark;    ///< on the check itself
    bool watched = false;  ///< did the sanitizers run?
    bool in_time = true;   ///< false if the compiler or the answer was stopped
    int line = 0;          ///< of the learner's file where it crashed
    std::uint64_t seed = 0;
    double seconds = 0;  ///< from the file to the verdict
};

/// The detail of a too_slow if the hidden tests, not the answer, worked too long.
inline constexpr const char* too_much_work_for_the_tests = "the hidden tests";

/// 64 random bits.
std::uint64_t new_seed();

/// The built files that a check compiles and links an answer with; the precompiled header comes last.
std::vector<std::filesystem::path> parts_of_check(const Exercise& exercise);

/// Are CMake's compile and link commands present and complete?
bool commands_are_whole(const Exercise& exercise);

/// One clear line where an answer has made use of the course's answers, tests or library: what of them stands, beside
/// the `answer` itself, in the list that the compiler has written for make. Empty: nothing. (forbidden_includes.cpp)
std::string forbidden_include(const std::filesystem::path& list, const std::filesystem::path& answer);

/// How a file is checked.
struct Manner {
    const Sandbox* sandbox = nullptr;  ///< for a stranger's file
    bool sanitizers = false;
    int patience = 1;  ///< multiplies the compiler's usual limits
};

/// Checks `file` as an answer to the exercise, with inputs drawn from `seed`. Throws Stop if the file cannot be read or
/// the machine is at fault.
Verdict check_file(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed,
                   const Manner& manner = {});

/// Checks with the sanitizers: errors that do not show in the numbers are crashes, and `printed` is the report. Throws
/// Stop(missing) if the compiler has no sanitizers.
Verdict check_sanitized(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed);

}  // namespace course
