#pragma once
// How ./course advise tells its answers, for people and as JSON: numbers, and what springs and dampers have in common.

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "advise.hpp"
#include "question.hpp"

namespace timestep {

using Json = nlohmann::ordered_json;

// JSON knows neither NaN nor infinity.
inline Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Rounded, in plain digits up to a million: 4300 and not 4.3e+03.
std::string rounded_to(double value, const char* format = "%.3g");

/// How often: a rate or a cost, from a hundred on whole.
std::string often(double value);

/// More or less by so many percent; from ten times on the factor.
std::string more(double fraction);

/// What something becomes in a second, over what it was. Zero is what no double can hold.
std::string factor(double value, const char* format = "%.3g");

/// How far off, as a share of the start.
std::string off(double error);

/// Cells side by side, each padded with blanks to its width in characters, and the last, which is not.
std::string row(std::initializer_list<std::pair<std::string, std::size_t>> cells, const std::string& last);

/// What is told, in the making.
struct Report {
    std::vector<Told> told;
    void print(const std::string& text) { told.push_back({text, false}); }
    void paragraph(const std::string& text) { told.push_back({text, true}); }
};

/// "chapter 8", of the section that an answer names, ch8_work or more8_work.
std::string chapter(const Choice& choice);

/// `text` without the marks of bold and of code.
std::string without_marks(const std::string& text);

[[noreturn]] inline void refuse_use(const std::string& line) {
    throw std::invalid_argument(line + " (./course advise --help)");
}

/// The step of the question, s; or, where frames are uneven, the longest of them and the shortest.
struct Step {
    double h, shortest;
    bool varying;
    std::string name;  // for people
    bool given;        // did the question name it?
};
Step step_of(const Question& question);
void refuse_two_steps(const Question& question);  ///< if both frames and a step are given
double accuracy_of(const Question& question);     ///< percent

Json as_json(const Recommendation& answer, const std::vector<Advice>& all);

// The table, what dies too slowly, and the reasons.
void print_table(Report& report, const std::vector<Advice>& all);
// Which methods are right at this step, and, where `longer` steps can be judged, which one reaches that most cheaply.
void print_right(Report& report, const std::vector<Advice>& all, const Step& asked, double accuracy, bool longer);
// The answer of which_method.hpp, its bold words bold. `where` the error is looked at, and the name of the rate's
// error.
void print_recommended(Report& report, const Recommendation& answer, const Step& asked, const std::string& where,
                       const std::string& rate);

// The answers to the three kinds of question.
std::vector<Told> answer_spring(const Question& question, bool json);
std::vector<Told> answer_damper(const Question& question, bool json);
std::vector<Told> answer_body(const Question& question, bool json);

}  // namespace timestep
