#include "check_in_process.hpp"

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <random>

#include "../course/exercises.hpp"
#include "../course/stop.hpp"
#include "../course/verdict_text.hpp"
#include "exercise.hpp"
#include "session.hpp"

namespace checker {

namespace {

// What another process would tell of the answer's end.
Answer with_no_answer(const Answer& answer) {
    return [answer](const Numbers& arguments) {
        try {
            return answer(arguments);
        } catch (const exercise::NotStarted&) {
            throw;
        } catch (const ArgumentsChanged&) {
            throw NoAnswer(Kind::wrong, "the arguments are only read: after the call the caller's are as they were");
        } catch (const std::bad_alloc&) {
            throw NoAnswer(Kind::too_much_memory, "");
        } catch (const std::exception& error) {
            throw NoAnswer(Kind::crash, std::string("an exception that nobody caught: ") + error.what());
        } catch (...) {
            throw NoAnswer(Kind::crash, "an exception that nobody caught");
        }
    };
}

}  // namespace

int check_in_process(const std::string& name, const Answer& answer, int count, char** words) {
    std::uint64_t seed = std::random_device{}();
    if (count > 1) {
        const char* const end = words[1] + std::strlen(words[1]);
        if (const auto read = std::from_chars(words[1], end, seed); read.ec != std::errc() || read.ptr != end) {
            std::fprintf(stderr, "check: the seed '%s' is no whole number from 0 to 2^64 - 1\n", words[1]);
            return 2;
        }
    }
    try {
        const auto begin = std::chrono::steady_clock::now();
        const Verdict found = session().check(name, with_no_answer(answer), seed);
        const course::Exercise exercise = course::find_exercise(name);
        course::Verdict verdict;
        static_cast<Finding&>(verdict) = found;
        verdict.kind = name_of(found.kind);
        if (found.kind != Kind::wrong && found.kind != Kind::not_finite) verdict.property.clear();
        verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        std::printf("%s%s", course::told(exercise, verdict, exercise.file()).c_str(),
                    course::marked(exercise, verdict, exercise.file()).c_str());
        if (found.kind != Kind::pass)
            std::printf("\n  The seed of these numbers: %llu\n", static_cast<unsigned long long>(seed));
        return found.kind == Kind::pass ? 0 : 1;
    } catch (const course::Stop& stop) {
        std::fprintf(stderr, "%s\n", stop.what());
        return 2;
    }
}

}  // namespace checker
