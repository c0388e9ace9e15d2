#pragma once
// How ./course advise writes its numbers, for people and as JSON.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

namespace course {

using Json = nlohmann::ordered_json;

// JSON knows neither NaN nor infinity.
inline Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// Rounded, in plain digits up to a million: 4300 and not 4.3e+03.
inline std::string number(double value, const char* format = "%.3g") {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "1e308 and more";
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    const double rounded = std::strtod(text, nullptr);
    const bool large = std::abs(rounded) >= 10 && std::abs(rounded) < 1e6;
    if (large && std::strchr(text, 'e')) std::snprintf(text, sizeof text, "%.0f", rounded);
    return text;
}

// How often: a rate or a cost, from a hundred on whole.
inline std::string often(double value) { return number(value, value >= 99.95 && value < 999999.5 ? "%.0f" : "%.3g"); }

// More or less by so many percent; from ten times on the factor.
inline std::string more(double fraction) {
    if (fraction >= 9) return "× " + number(fraction + 1, fraction < 1e6 ? "%.0f" : "%.3g");
    return number(100 * fraction, std::abs(fraction) < 0.995 ? "%+.2g" : "%+.0f") + " %";
}

// What something becomes in a second, over what it was. Zero is what no double can hold.
inline std::string factor(double value, const char* format = "%.3g") {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "× over 1e308";
    return "× " + (value < 1e-308 ? "under 1e-308" : number(value, format));
}

}  // namespace course
