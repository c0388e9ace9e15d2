#pragma once
/// \file
/// What is wrong with a command line, in one line of the course's own words.

#include <string>

#include <CLI/CLI.hpp>

namespace course {

/// Why `word` is no double; "" if it is one. CLI11 itself takes '' for a missing word, and reads a number that no
/// double can hold as infinity or zero.
std::string no_double(const std::string& word);

/// What CLI11 refused, without its own terms.
std::string in_our_words(const CLI::ParseError& error, const CLI::App& app);

/// " (./course bench --help)" for the command that was given.
std::string see_help(const CLI::App& app);

/// What to type instead of `./course run 3 --omega 20`; "" if the mistake is another.
std::string forgotten_dashes(const CLI::App& app, const std::string& chapter);

}  // namespace course
