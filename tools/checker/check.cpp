// The hidden tests' program: checks a worker with a learner's code.
//
//     check EXERCISE WORKER [PRINTED [sanitizers | memcheck | LAUNCHER…]]
//
// with inputs drawn from the seed on the standard input, for a command line can be read by all;
// what the learner's code prints left in the file PRINTED; the worker watched by the sanitizers
// that it is compiled with or by valgrind's memcheck, or started by the words LAUNCHER. It prints
// lines  key<TAB>value, which ./course check puts into words; in a value, control characters are
// \n, \t and \xNN, and a backslash is \\. Exit status 0 when the answer is right, 1 when it is not,
// 2 for wrong use.

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>

#include <sys/prctl.h>

#include "remote.hpp"
#include "session.hpp"

namespace {

// So that nothing the learner's code says makes a line of its own.
std::string escaped(const std::string& text) {
    std::string line;
    for (const char c : text) {
        char code[8] = {c, '\0'};
        if (c == '\n' || c == '\t')
            std::snprintf(code, sizeof code, "\\%c", c == '\n' ? 'n' : 't');
        else if (c == '\\')
            std::snprintf(code, sizeof code, "\\\\");
        else if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
            std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned char>(c));
        line += code;
    }
    return line;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace checker;
    // The learner's code is not to reach this process's files through /proc.
    prctl(PR_SET_DUMPABLE, 0);
    std::uint64_t seed = 0;
    if (argc < 3) {
        std::fprintf(stderr, "check: takes EXERCISE WORKER [PRINTED [WATCH or LAUNCHER...]]\n");
        return 2;
    }
    char word[32] = "";
    if (!std::fgets(word, sizeof word, stdin)) word[0] = '\0';
    word[std::strcspn(word, "\n")] = '\0';
    const char* const end = word + std::strlen(word);
    if (const auto read = std::from_chars(word, end, seed); read.ec != std::errc() || read.ptr != end) {
        std::fprintf(stderr, "check: the seed '%s' is no whole number from 0 to 2^64 - 1\n", word);
        return 2;
    }
    Verdict verdict;
    try {
        Limits limits;
        std::vector<std::string> launcher(argv + std::min(argc, 4), argv + argc);
        if (argc == 5 && (launcher[0] == "sanitizers" || launcher[0] == "memcheck")) {
            limits.watch = launcher[0] == "memcheck" ? Watch::memcheck : Watch::sanitizers;
            limits.call_seconds = limits.total_seconds = 20;
            launcher.clear();
        }
        Remote remote(argv[2], argc > 3 ? argv[3] : "/dev/null", launcher, limits);
        remote.await();
        verdict = session().check(argv[1], std::ref(remote), seed);
        if (verdict.kind == Kind::pass && limits.watch == Watch::nobody) {
            verdict.arguments = at_the_end;
            remote.await_end();
        }
        if (verdict.kind != Kind::crash) remote.close_down();
    } catch (const NoAnswer& ended) {
        verdict.kind = ended.kind;
        verdict.detail = ended.what();
        verdict.trace = ended.trace;
    }
    const auto say = [](const char* key, const std::string& value) {
        std::printf("%s\t%s\n", key, escaped(value).c_str());
    };
    say("seed", word);
    say("verdict", name_of(verdict.kind));
    say("property", verdict.property);
    say("misconception", verdict.misconception);
    say("detail", verdict.detail);
    say("trace", verdict.trace);
    say("arguments", verdict.arguments);
    say("result", verdict.result);
    say("right", verdict.right);
    return verdict.kind == Kind::pass ? 0 : 1;
}
