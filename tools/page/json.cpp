#include "json.hpp"

#include "error.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace page {
namespace {

/// What the library says, as `file:line: message`.
Error error_of(const nlohmann::json::parse_error& wrong, std::string_view text, const std::string& file) {
    const std::size_t before = wrong.byte == 0 ? 0 : wrong.byte - 1;
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(before, text.size()));
    std::string words = wrong.what();
    const std::size_t place = words.find("column ");  // the line stands before the message already
    words.erase(0, place == std::string::npos ? 0 : words.find(": ", place) + 2);
    return {file, 1 + static_cast<int>(std::count(text.begin(), end, '\n')), words};
}

void flatten(const nlohmann::json& object, const std::string& prefix, const std::string& file, Json& flat) {
    for (const auto& [name, value] : object.items()) {
        const std::string key = prefix + name;
        if (value.is_object()) {
            flatten(value, key + ".", file, flat);
        } else if (value.is_string()) {
            flat[key] = {value.get<std::string>()};
        } else if (value.is_number() || value.is_boolean()) {
            flat[key] = {value.dump()};
        } else if (value.is_array() &&
                   std::all_of(value.begin(), value.end(), [](const auto& item) { return item.is_string(); })) {
            flat[key] = value.get<std::vector<std::string>>();
        } else {
            throw Error{file, 1, "\"" + key + "\" must be words, a list of them, a number, true or false"};
        }
    }
}

}  // namespace

Json parse_json(std::string_view text, const std::string& file) {
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& wrong) {
        throw error_of(wrong, text, file);
    }
    if (!json.is_object()) {
        throw Error{file, 1, "must be an object: { … }"};
    }
    Json flat;
    flatten(json, "", file, flat);
    return flat;
}

}  // namespace page
