// The hidden tests' program: checks a worker with a learner's code.
//
//     check EXERCISE WORKER SEED PRINTED
//
// prints lines  key<TAB>value, which ./course check puts into words. Exit status 0 when the answer is
// right, 1 when it is not, 2 for wrong use.

#include <charconv>
#include <cstdio>
#include <cstring>
#include <string>

#include "remote.hpp"
#include "session.hpp"

int main(int argc, char** argv) {
    using namespace checker;
    std::uint64_t seed = 0;
    if (argc != 5) {
        std::fprintf(stderr, "check: takes EXERCISE WORKER SEED PRINTED\n");
        return 2;
    }
    const char* const end = argv[3] + std::strlen(argv[3]);
    if (const auto read = std::from_chars(argv[3], end, seed); read.ec != std::errc() || read.ptr != end) {
        std::fprintf(stderr, "check: the seed '%s' is no whole number from 0\n", argv[3]);
        return 2;
    }
    Verdict verdict;
    try {
        Remote remote(argv[2], argv[4]);
        verdict = session().check(argv[1], std::ref(remote), seed);
    } catch (const Ended& ended) {
        verdict.kind = ended.kind;
        verdict.detail = ended.what();
    }
    std::printf("verdict\t%s\nproperty\t%s\nmisconception\t%s\ndetail\t%s\n", name_of(verdict.kind),
                verdict.property.c_str(), verdict.misconception.c_str(), verdict.detail.c_str());
    std::printf("arguments\t");
    for (const double x : verdict.last.arguments) std::printf(" %.6g", x);
    std::printf("\nresult\t");
    for (const double x : verdict.last.result) std::printf(" %.10g", x);
    std::printf("\n");
    return verdict.kind == Kind::pass ? 0 : 1;
}
