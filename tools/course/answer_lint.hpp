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
/// are numerals, and the arguments that `declaration` gives as int.
std::string divided_whole_numbers(const std::string& code, const std::string& declaration);

/// Does `auto` keep a value that is neither a lambda nor a structured binding?
bool keeps_by_auto(const std::string& code);

/// Why the definition of `name` in `code` is not the function that the checker calls, and what to do: it is static,
/// inline or a template, or stands in a namespace or a class. Nothing where it is none of these, or where there is no
/// definition.
std::string uncallable_definition(const std::string& code, const std::string& name);

/// Is the text in UTF-16, as some editors save "Unicode"?
bool is_utf16(const std::string& text);

}  // namespace course
