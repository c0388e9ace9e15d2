// Tests the tests of one exercise: what is not started, what is right and what is wrong must be
// told apart, whatever the seed.
//
//     self_test EXERCISE SEEDS
//
// Right answers are checked with so many seeds, mistakes with a tenth of that.

#include <charconv>
#include <cstdio>
#include <string>

#include "self_test.hpp"
#include "session.hpp"

namespace checker {

namespace {

int failures = 0;

void expect(const std::string& variant, std::uint64_t seed, const Verdict& verdict, Kind kind,
            const std::string& misconception) {
    const bool as_expected =
        misconception.empty() ? verdict.kind == kind
                              : (verdict.kind == Kind::wrong || verdict.kind == Kind::not_finite) &&
                                    verdict.misconception == misconception;
    if (as_expected) return;
    ++failures;
    std::printf("%s, seed %llu: must be %s %s, but is %s %s\n", variant.c_str(),
                static_cast<unsigned long long>(seed),
                misconception.empty() ? name_of(kind) : "wrong:", misconception.c_str(),
                name_of(verdict.kind), verdict.misconception.c_str());
    if (!verdict.property.empty()) std::printf("  the property: %s\n", verdict.property.c_str());
    std::printf("  %s gives %s  %s\n", verdict.arguments.c_str(), verdict.result.c_str(),
                verdict.detail.c_str());
}

void test(const std::string& exercise, std::uint64_t seeds) {
    const Variants& all = variants_of(exercise);
    expect("the stub", 1, session().check(exercise, all.stub, 1), Kind::not_started, "");
    for (const auto& [name, answer] : all.correct)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed)
            expect(name, seed, session().check(exercise, answer, seed), Kind::pass, "");
    for (const auto& [name, made] : mistakes_of(exercise))
        for (std::uint64_t seed = 1; seed <= seeds / 10; ++seed)
            expect(name, seed, session().check(exercise, made.answer, seed), Kind::wrong, name);
    const auto print = [](std::uint64_t number) { return static_cast<unsigned long long>(number); };
    std::printf("%s: %zu right answers, %llu seeds each; %zu mistakes, %llu seeds each\n",
                exercise.c_str(), all.correct.size(), print(seeds), mistakes_of(exercise).size(),
                print(seeds / 10));
}

}  // namespace

}  // namespace checker

int main(int argc, char** argv) {
    std::uint64_t seeds = 0;
    const std::string word = argc == 3 ? argv[2] : "";
    const auto read = std::from_chars(word.data(), word.data() + word.size(), seeds);
    if (read.ptr != word.data() + word.size() || seeds < 10) {
        std::fprintf(stderr, "self_test: takes EXERCISE SEEDS, of which there are 10 or more\n");
        return 2;
    }
    checker::test(argv[1], seeds);
    return checker::failures == 0 ? 0 : 1;
}
