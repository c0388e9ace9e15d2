#pragma once
/// \file
/// A verdict in words that a beginner understands at once, or as JSON.

#include <string>

#include "verdict.hpp"

namespace course {

/// What is printed of a verdict. `file` is the answer that was checked.
std::string told(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file);

/// Below it, for an editor: "FILE:LINE: error: words", the line on which it crashed or on which the function begins.
/// Nothing where there is nothing to mark, or the compiler has marked it.
std::string marked(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file);

/// A verdict's kind in two or three words: "does not compile".
std::string headline(const std::string& kind);

/// exercise, verdict, property, misconception, seed and seconds; what does not apply is null.
std::string as_json(const Exercise& exercise, const Verdict& verdict);

}  // namespace course
