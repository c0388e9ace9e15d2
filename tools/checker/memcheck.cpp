#include "memcheck.hpp"

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "no_answer.hpp"

namespace checker {

namespace {

// Of a line  ==123==    by 0x401B0C: f() (answer.cpp:7)  the address; where a call returns to is
// one place too far. Nothing where there is none.
std::string address_in(const std::string& line) {
    for (const char* const word : {" at 0x", " by 0x"})
        if (const auto place = line.find(word); place != std::string::npos) {
            const auto address = std::strtoull(line.c_str() + place + 4, nullptr, 16);
            char text[32];
            std::snprintf(text, sizeof text, "0x%llx", address - (word[1] == 'b'));
            return text;
        }
    return {};
}

}  // namespace

void look_through(const std::string& log) {
    if (log.empty()) return;
    std::string trace;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        const std::string address = address_in(line);
        // The first error ends before the first line without words.
        if (address.empty() && line.ends_with("== ") && !trace.empty()) break;
        if (!address.empty()) trace += (trace.empty() ? "" : " ") + address;
    }
    const bool unwritten = log.substr(0, log.find(" at 0x")).find("ninitialised") != std::string::npos;
    throw NoAnswer(
        Kind::crash,
        unwritten ? "a value is used that was never written" : "memory is used that does not belong to the program",
        trace);
}

}  // namespace checker
