#pragma once
/// \file
/// A verdict in plain words, or as JSON.

#include <string>

#include "verdict.hpp"

namespace course {

/// What the learner reads. `file` is the answer that was checked.
std::string told(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file);

/// What the learner is told of a mistake that the checker has found (tools/checker/diagnose.cpp), in a paragraph or
/// two; nothing where nothing is known. (misconception.cpp)
std::string told_of(const Exercise& exercise, const checker::Diagnosis& diagnosis);

/// "FILE:LINE: error: words" for an editor: the line of the crash, or the first line of the function. Nothing if there
/// is nothing to mark, or if the compiler's own message marks it.
std::string marked(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file);

/// A verdict's kind in two or three words: "does not compile".
std::string headline(const std::string& kind);

/// exercise, verdict, property, misconception, seed and seconds; what does not apply is null.
std::string as_json(const Exercise& exercise, const Verdict& verdict);

}  // namespace course
