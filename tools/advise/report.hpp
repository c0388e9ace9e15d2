#pragma once
// How ./course advise tells its answers: numbers, for people and as JSON, and what springs and dampers have in common.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "advise.hpp"
#include "question.hpp"

namespace timestep {

using Json = nlohmann::ordered_json;

// JSON knows neither NaN nor infinity.
inline Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

// Rounded, in plain digits up to a million: 4300 and not 4.3e+03.
inline std::string rounded_to(double value, const char* format = "%.3g") {
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
inline std::string often(double value) {
    return rounded_to(value, value >= 99.95 && value < 999999.5 ? "%.0f" : "%.3g");
}

// More or less by so many percent; from ten times on the factor.
inline std::string more(double fraction) {
    if (fraction >= 9) return "× " + rounded_to(fraction + 1, fraction < 1e6 ? "%.0f" : "%.3g");
    return rounded_to(100 * fraction, std::abs(fraction) < 0.995 ? "%+.2g" : "%+.0f") + " %";
}

// What something becomes in a second, over what it was. Zero is what no double can hold.
inline std::string factor(double value, const char* format = "%.3g") {
    if (std::isnan(value)) return "-";
    if (std::isinf(value)) return "× over 1e308";
    return "× " + (value < 1e-308 ? "under 1e-308" : rounded_to(value, format));
}

/// What is told, in the making.
class Report {
public:
    /// As std::printf has it.
    [[gnu::format(printf, 2, 3)]] void print(const char* format, ...);
    void paragraph(const std::string& words) { told.push_back({words, true}); }
    std::vector<Told> told;
};

/// `text`, padded with blanks to `width` characters (not bytes).
std::string padded(const std::string& text, std::size_t width);

/// "chapter 8", of the section that an answer names, ch8_work or more8_work.
std::string chapter(const Choice& choice);

/// `text` without the marks of bold and of code.
std::string without_marks(const std::string& text);

[[noreturn]] inline void refuse_use(const std::string& line) {
    throw std::invalid_argument(line + " (./course advise --help)");
}

/// The step of the question, s.
double step_of(const Question& question);
double accuracy_of(const Question& question);  ///< percent

// The step of the question, and whether it was given.
struct Step {
    double h;
    std::string name;  // for people
    bool given;
};

Json as_json(const Recommendation& answer, const std::vector<Advice>& all);

// How far off, as a share of the start.
std::string off(double error);
// The table, what dies too slowly, and the reasons.
void print_table(Report& report, const std::vector<Advice>& all);
// Which methods are right at this step, and, unless frames vary, which one reaches that most cheaply.
void print_right(Report& report, const std::vector<Advice>& all, const Step& asked, double accuracy, bool varying);
// The answer of which_method.hpp, its bold words bold; `where` begins with "in" or "while": where the error is looked
// at.
void print_recommended(Report& report, const Recommendation& answer, const Step& asked, bool varying,
                       const std::string& where);

// The answers to the three kinds of question.
std::vector<Told> answer_spring(const Question& question, bool json);
std::vector<Told> answer_damper(const Question& question, bool json);
std::vector<Told> answer_body(const Question& question, bool json);

}  // namespace timestep
