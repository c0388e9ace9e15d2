#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace page {

/// What about.json holds: a value under each key is a string, a number, true or false, a list of
/// strings, or an object. All but a list is kept as a list of one; what an object holds, under names
/// like `mistakes.sign.hint`.
using Json = std::map<std::string, std::vector<std::string>>;

/// Reads an object of these. Anything else is an Error at `file` and line.
Json parse_json(std::string_view text, const std::string& file);

}  // namespace page
