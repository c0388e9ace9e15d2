// course advise

#include <cstdio>
#include <stdexcept>

#include "question.hpp"

#include "commands.hpp"
#include "stop.hpp"
#include "terminal.hpp"

namespace course {

namespace {

// What stands between pairs of asterisks in bold.
std::string with_bold(std::string words) {
    for (std::size_t at = words.find("**"); at != std::string::npos; at = words.find("**")) {
        const std::size_t end = words.find("**", at + 2);
        words = words.substr(0, at) + bold(words.substr(at + 2, end - at - 2)) + words.substr(end + 2);
    }
    return words;
}

}  // namespace

void advise(const timestep::Question& question, bool json) {
    try {
        for (const auto& [text, paragraph] : timestep::answer(question, json)) {
            const std::string words = json ? text : with_bold(text);
            std::fputs((paragraph ? wrapped(words, 0) : words).c_str(), stdout);
        }
    } catch (const std::invalid_argument& error) {
        throw Stop(Status::bad_use, error.what());
    }
}

}  // namespace course
