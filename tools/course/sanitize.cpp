// course check --sanitize

#include "read_json.hpp"

#include "paths.hpp"
#include "process.hpp"
#include "stop.hpp"
#include "verdict.hpp"

namespace course {

namespace {

// Watched, everything takes many times as long. What counts is the check that all others get.
Verdict unwatched(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed) {
    Verdict verdict = check_file(exercise, file, seed);
    if (verdict.kind == "pass")
        verdict.remark = "The answer is right, but too slow to be watched: not all of it has been.";
    return verdict;
}

}  // namespace

Verdict check_sanitized(const Exercise& exercise, const std::filesystem::path& file, std::uint64_t seed) {
    if (!commands_are_whole(exercise)) return check_file(exercise, file, seed);  // which says so
    const auto json = read_json(contents(paths().build / "exercises/commands.json"));
    if (json.at("sanitize").empty())
        throw Stop(Status::missing,
                   "check --sanitize: the compiler has no AddressSanitizer and no "
                   "UndefinedBehaviorSanitizer to link with");
    Verdict verdict = check_file(exercise, file, seed, nullptr, Watch::sanitizers);
    if (verdict.kind == "too_slow") return unwatched(exercise, file, seed);
    if (verdict.kind != "pass") return verdict;
    if (run_within({"valgrind", "--version"}, {.seconds = 60, .processor_seconds = 5}).status != 0) {
        verdict.remark = "Values that were never written have not been looked for: there is no valgrind.";
        return verdict;
    }
    Verdict again = check_file(exercise, file, seed, nullptr, Watch::memcheck);
    if (again.kind == "too_slow") again = unwatched(exercise, file, seed);
    again.seconds += verdict.seconds;
    return again;
}

}  // namespace course
