#pragma once
/// \file
/// A verdict in words that a beginner understands at once, or as JSON.

#include <string>

#include "verdict.hpp"

namespace course {

/// What is printed of a verdict. `file` is the answer that was checked.
std::string told(const Exercise& exercise, const Verdict& verdict,
                 const std::filesystem::path& file);

/// A verdict's kind in two or three words: "does not compile".
std::string headline(const std::string& kind);

/// exercise, verdict, property, misconception, seed and seconds; what does not apply is null.
std::string as_json(const Exercise& exercise, const Verdict& verdict);

}  // namespace course
