#pragma once
/// \file
/// Faults that show in the text of an answer.

#include <string>

#include "verdict.hpp"

namespace course {

/// Paragraphs that stand below why the answer is wrong: on whole numbers that are divided, and on expressions of Eigen
/// that `auto` keeps.
std::string answer_lint(const Exercise& exercise, const Verdict& verdict, const std::filesystem::path& file);

/// The first quotient of whole numbers in `code` that leaves a rest, or may leave one, in one sentence or two. Whole
/// are numerals, and below the line also the arguments that `declaration` gives as int.
std::string divided_whole_numbers(const std::string& code, const std::string& declaration);

/// Does `auto` keep a value that is neither a lambda nor a structured binding?
bool keeps_by_auto(const std::string& code);

}  // namespace course
