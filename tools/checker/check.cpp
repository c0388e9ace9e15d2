// The hidden tests' program: checks a worker with a learner's code.
//
//     check EXERCISE WORKER [PRINTED [sanitizers | LAUNCHER…]]
//
// with inputs drawn from the seed on the standard input, for a command line can be read by all; what the learner's code
// prints left in the file PRINTED; the worker compiled with sanitizers, or started by the words LAUNCHER. It prints
// {"kind": …, "finding": …} (finding_json.hpp), which ./course check puts into words. Exit status 0 when the answer is
// right, 1 when it is not, 2 for wrong use.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <string>

#include <sys/prctl.h>

#include "finding_json.hpp"
#include "remote.hpp"
#include "session.hpp"

namespace {

using namespace checker;

Verdict verdict_on(const std::string& exercise, const std::string& worker, const std::string& printed,
                   std::vector<std::string> launcher, std::uint64_t seed) {
    Verdict verdict;
    try {
        Limits limits;
        if (launcher == std::vector<std::string>{"sanitizers"}) {
            limits.sanitizers = true;
            limits.total_seconds = 40;
            launcher.clear();
        }
        Remote remote(worker, printed, launcher, limits);
        remote.await();
        verdict = session().check(exercise, std::ref(remote), seed);
        if (verdict.kind == Kind::pass && !limits.sanitizers) {
            verdict.arguments = at_the_end;
            remote.await_end();
        }
    } catch (const NoAnswer& none) {
        verdict.kind = none.kind;
        verdict.detail = none.what();
        verdict.trace = none.trace;
    }
    return verdict;
}

}  // namespace

int main(int argc, char** argv) try {
    // The learner's code is not to reach this process's files through /proc.
    prctl(PR_SET_DUMPABLE, 0);
    if (argc < 3) throw std::invalid_argument("takes EXERCISE WORKER [PRINTED [sanitizers or LAUNCHER...]]");
    std::string word;
    std::getline(std::cin, word);
    std::uint64_t seed = 0;
    const char* const end = word.data() + word.size();
    if (const auto read = std::from_chars(word.data(), end, seed); read.ec != std::errc() || read.ptr != end)
        throw std::invalid_argument("the seed '" + word + "' is no whole number from 0 to 2^64 - 1");
    registered(argv[1]);
    const Verdict verdict =
        verdict_on(argv[1], argv[2], argc > 3 ? argv[3] : "/dev/null", {argv + std::min(argc, 4), argv + argc}, seed);
    const nlohmann::json found{{"kind", name_of(verdict.kind)}, {"finding", static_cast<const Finding&>(verdict)}};
    std::puts(found.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
    return verdict.kind == Kind::pass ? 0 : 1;
} catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "check: %s\n", error.what());
    return 2;
}
