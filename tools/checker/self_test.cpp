// Tests the tests of one exercise: what is not started, what is right and what is wrong must be
// told apart, whatever the seed; and of what is told of the mistakes, half must be worked out easily.
//
//     self_test EXERCISE SEEDS
//     self_test EXERCISE slips
//
// Right answers are checked with so many seeds, mistakes with a tenth of that. With `slips`, each slip that can be made
// in the right answers is checked with one seed: it must be caught, unless its every answer is right, and have a name.
// Without a slip they must pass.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

#include "session.hpp"
#include "slips.hpp"

namespace checker {

namespace {

int failures = 0;

void expect(const std::string& variant, std::uint64_t seed, const Verdict& verdict, Kind kind,
            const std::string& misconception) {
    const bool as_expected = misconception.empty()
                                 ? verdict.kind == kind
                                 : (verdict.kind == Kind::wrong || verdict.kind == Kind::not_finite) &&
                                       verdict.diagnosis.label() == misconception;
    if (as_expected) return;
    ++failures;
    std::printf("%s, seed %llu: must be %s %s, but is %s %s\n", variant.c_str(), static_cast<unsigned long long>(seed),
                misconception.empty() ? name_of(kind) : "wrong:", misconception.c_str(), name_of(verdict.kind),
                verdict.diagnosis.label().c_str());
    if (!verdict.property.empty()) std::printf("  the property: %s\n", verdict.property.c_str());
    std::printf("  %s gives %s  %s\n", verdict.arguments.c_str(), verdict.result.c_str(), verdict.detail.c_str());
}

void test(const std::string& exercise, std::uint64_t seeds) {
    const Registered& all = registered(exercise);
    expect("the stub", 1, session().check(exercise, all.stub, 1), Kind::not_started, "");
    for (const auto& [name, answer] : all.correct)
        for (std::uint64_t seed = 1; seed <= seeds; ++seed)
            expect(name, seed, session().check(exercise, answer, seed), Kind::pass, "");
    std::size_t messages = 0, short_ones = 0;
    for (const auto& [name, made] : all.mistakes)
        for (std::uint64_t seed = 1; seed <= seeds / 10; ++seed) {
            const Verdict verdict = session().check(exercise, made.answer, seed);
            expect(name, seed, verdict, Kind::wrong, name);
            ++messages, short_ones += long_numbers(verdict.arguments) == 0;
        }
    std::printf("%s: %zu right answers, %llu seeds each; %zu mistakes, a tenth of that\n", exercise.c_str(),
                all.correct.size(), static_cast<unsigned long long>(seeds), all.mistakes.size());
    // One exercise's properties are of whole runs, and what is wrong is seen at the end of one.
    const bool can_be_short = exercise != "fourth_order_leapfrog", are_short = 2 * short_ones >= messages;
    if (can_be_short && !are_short) ++failures;
    std::printf("%s: %zu of %zu messages show a call without a number of more than four digits%s\n", exercise.c_str(),
                short_ones, messages, can_be_short && !are_short ? ": must be half of them" : "");
}

// Does the slip ever leave its vectors, or not end? Then no worker would bring its answers to the tests.
struct LeadsNowhere {};

void test_slips(const std::string& exercise) {
    std::size_t caught = 0, named = 0, right = 0, nowhere = 0;
    for (const Answer& answer : registered(exercise).slips) {
        std::vector<slip::Made> slips;
        const Answer noting = [&](const Numbers& arguments) {
            slip::note(answer, arguments, slips);
            return registered(exercise).truth.answer(arguments);
        };
        session().check(exercise, noting, 1);
        const Answer without = [&](const Numbers& arguments) {
            const Numbers result = slip::answered(answer, arguments, {});  // none where it takes too many turns
            return result.empty() ? registered(exercise).truth.answer(arguments) : result;
        };
        expect("a right answer, written so that it can slip", 1, session().check(exercise, without, 1), Kind::pass, "");
        const bool is_solution = &answer == &registered(exercise).slips.front();
        for (const slip::Made& made : slips) {
            if (!is_solution && made.form > slip::last_of_arithmetic) continue;  // no name is looked for there
            bool leads_nowhere = false;
            double most = 0;
            const Answer slipping = [&](const Numbers& arguments) {
                const Numbers result = slip::answered(answer, arguments, made);
                leads_nowhere |= result.empty();
                if (result.empty()) throw NoAnswer(Kind::crash, "a slip that leads nowhere");
                const Numbers truth = registered(exercise).truth.answer(arguments);
                for (std::size_t i = 0; i < std::min(truth.size(), result.size()); ++i)
                    most = std::max(most, std::fabs(result[i] - truth[i]) / std::max(1e-300, std::fabs(truth[i])));
                return result;
            };
            const Verdict verdict = session().check(exercise, slipping, 1);
            if (leads_nowhere) {
                ++nowhere;
            } else if (verdict.kind == Kind::pass) {
                ++right;
                if (registered(exercise).within.relative != many_are_right && most > 1e-3) {
                    ++failures;
                    std::printf("%s: the slip %s at %d is off by %g, and passes\n", exercise.c_str(),
                                slip::name_of(made.form), made.site, most);
                }
            } else {
                ++caught;
                named += !verdict.diagnosis.empty();
            }
        }
    }
    std::printf(
        "%s: of the slips %zu are caught, %zu of them by name; %zu change nothing that is wrong, %zu lead nowhere\n",
        exercise.c_str(), caught, named, right, nowhere);
    if (10 * named < 9 * caught) ++failures;
}

}  // namespace

}  // namespace checker

int main(int argc, char** argv) try {
    const std::string word = argc == 3 ? argv[2] : "";
    std::uint64_t seeds = 0;
    if (word == "slips")
        checker::test_slips(argv[1]);
    else if (std::from_chars(word.data(), word.data() + word.size(), seeds).ptr == word.data() + word.size() &&
             seeds >= 10)
        checker::test(argv[1], seeds);
    else
        throw std::invalid_argument("'" + word +
                                    "': must be a number of seeds from 10 on, or slips, behind the exercise");
    return checker::failures == 0 ? 0 : 1;
} catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "self_test: %s\n", error.what());
    return 2;
}
