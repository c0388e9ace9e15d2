#include "read_json.hpp"

namespace course {

nlohmann::json read_json(const std::string& text) { return nlohmann::json::parse(text); }

nlohmann::json try_read_json(const std::string& text) { return nlohmann::json::parse(text, nullptr, false); }

}  // namespace course
