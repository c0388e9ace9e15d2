#pragma once
// ./course advise: what is told alike of springs and of a damper alone.

#include <string>
#include <vector>

#include "advise_recommend.hpp"

#include "advise_words.hpp"

namespace course {

// The step of the question, and whether it was given.
struct Step {
    double h;
    std::string name;  // for people
    bool given;
};

Json as_json(const timestep::Recommendation& answer, const std::vector<timestep::Advice>& all);

// How far off, as a share of the start.
std::string off(double error);
// Paragraphs of a terminal's width.
void line(const std::string& words);

// The table, what dies too slowly, and the reasons.
void print_table(const std::vector<timestep::Advice>& all);
// Which methods are right at this step, and, unless frames vary, which one reaches that most cheaply.
void print_right(const std::vector<timestep::Advice>& all, const Step& asked, double accuracy, bool varying);
// The answer of which_method.hpp, its bold words bold; `where` begins with "in" or "while": where the error is looked
// at.
void print_recommended(const timestep::Recommendation& answer, const Step& asked, bool varying,
                       const std::string& where);

}  // namespace course
