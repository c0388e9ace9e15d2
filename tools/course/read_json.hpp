#pragma once
/// \file
/// Reading JSON: compiled once and optimised, since every command reads some.

#include <string>

#include <nlohmann/json.hpp>

namespace course {

/// Throws nlohmann::json::exception if the text is not JSON.
nlohmann::json read_json(const std::string& text);

/// Returns a value that is_discarded() if the text is not JSON.
nlohmann::json try_read_json(const std::string& text);

}  // namespace course
