#pragma once
/// \file
/// A function that stands in a learner's file, and that the checker's file cannot call all the same.

#include <string>

namespace course {

/// Why the definition of `name` in `code` is not the function that the checker calls, and what to do: it is static,
/// inline or a template, or stands in a namespace or a class. Nothing where it is none of these, or where there is no
/// definition.
std::string uncallable_definition(const std::string& code, const std::string& name);

/// Is the text in UTF-16, as some editors save "Unicode"?
bool is_utf16(const std::string& text);

}  // namespace course
