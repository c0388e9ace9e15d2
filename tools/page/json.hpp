#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace page {

/// What about.json holds: a value under each key is a string or a list of strings. A string is kept
/// as a list of one.
using Json = std::map<std::string, std::vector<std::string>>;

/// Reads an object of strings and lists of strings. Anything else is an Error at `file` and line.
Json parse_json(std::string_view text, const std::string& file);

}  // namespace page
