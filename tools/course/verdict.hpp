#pragma once
/// \file
/// From a learner's file to a verdict: compile it, link it with its worker, let the hidden tests
/// call it.

#include <cstdint>
#include <filesystem>
#include <string>

#include "exercises.hpp"
#include "sandbox.hpp"
#include "stop.hpp"

namespace course {

/// What a check has found. `kind` is one of: pass, does_not_compile, not_started, wrong,
/// not_finite, crash, too_slow, too_much_memory, left_early, course_error.
struct Verdict {
    std::string kind;
    std::string property;       ///< wrong: the first that does not hold
    std::string misconception;  ///< the name of the known mistake that answers just so, if any
    std::string detail;         ///< of a crash and the like
    std::string arguments;      ///< of the last call: "(1, 2)"
    std::string result;         ///< and what it returned
    std::string right;          ///< what it must return, where that was something else
    std::string compiler;       ///< what the compiler said, warnings included
    std::string printed;        ///< what the learner's code printed
    std::string remark;         ///< on the check itself
    bool watched = false;       ///< was it asked for what the sanitizers see?
    bool in_time = true;        ///< false where compiler or answer had not come to an end
    int line = 0;               ///< of the learner's file where it crashed
    std::uint64_t seed = 0;
    double seconds = 0;  ///< from the file to the verdict
};

/// The detail of a too_slow where it was not the answer that worked too long.
inline constexpr const char* too_much_work_for_the_tests = "the hidden tests";

/// Who looks over the shoulder of the learner's code: nobody; the sanitizers that the compiler
/// builds in; valgrind's memcheck.
enum class Watch { nobody, sanitizers, memcheck };

/// The built files for a check are damaged: the compiler refuses the course's own file, too.
class Damaged : public Stop {
public:
    Damaged(bool header, const std::string& compiler);
    bool header() const {
        return header_;
    }  ///< is it the header compiled beforehand, or what an answer is linked with?

private:
    bool header_;
};

/// 64 random bits.
std::uint64_t new_seed();

/// The program that holds the hidden tests of the exercise.
std::filesystem::path hidden_tests_of(const Exercise& exercise);

/// The built files that a check compiles and links an answer with; the precompiled header comes last.
std::vector<std::filesystem::path> parts_of_check(const Exercise& exercise);

/// Are CMake's compile and link commands present and complete?
bool commands_are_whole(const Exercise& exercise);

/// Checks `file` as an answer to the exercise, with inputs drawn from `seed`; a stranger's in a
/// sandbox, watched by nobody. The compiler has `patience` times what it has usually. Throws Stop where
/// the file cannot be read or the machine is at fault, and Damaged.
Verdict check_file(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed,
                   const Sandbox* sandbox = nullptr, Watch watch = Watch::nobody, int patience = 1);

/// The same with the sanitizers and, where nothing is wrong and it is there, with valgrind: errors
/// that do not show in the numbers are crashes. Throws Stop(missing) where the compiler has no
/// sanitizers.
Verdict check_sanitized(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed);

}  // namespace course
