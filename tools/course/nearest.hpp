#pragma once
/// \file
/// What somebody may have meant who has misspelt a name.

#include <string>
#include <vector>

namespace course {

/// How many letters one word is away from another: changed, left out, too many, or two that changed places.
std::size_t distance(const std::string& a, const std::string& b);

/// The name that is nearest to `word`, whose capitals and hyphens do not count; "" where none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& names);

}  // namespace course
