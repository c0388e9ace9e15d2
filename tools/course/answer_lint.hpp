#pragma once
/// \file
/// What the text of an answer shows that is wrong.

#include <string>

#include "verdict.hpp"

namespace course {

/// Paragraphs that stand below why the answer is wrong: of whole numbers that are divided, and of what `auto` keeps.
std::string answer_lint(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file);

}  // namespace course
