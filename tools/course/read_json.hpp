#pragma once
/// \file
/// Reading JSON: compiled once, and optimised, for what every command waits for.

#include <string>

#include <nlohmann/json.hpp>

namespace course {

/// What the text says. Throws nlohmann::json::exception where it is no JSON.
nlohmann::json read_json(const std::string& text);

/// The same; where it is no JSON, a value that is_discarded().
nlohmann::json try_read_json(const std::string& text);

}  // namespace course
