#pragma once
// ./course advise: what its two kinds of question share.

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "stop.hpp"

namespace course {

using Json = nlohmann::ordered_json;

[[noreturn]] inline void refuse(const std::string& line) {
    throw Stop(Status::bad_use, line + " (./course advise --help)");
}

// JSON knows neither NaN nor infinity.
inline Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double step_of(const Question& question);

void advise_spring(const Question& question, bool json);
void advise_body(const Question& question, bool json);

}  // namespace course
