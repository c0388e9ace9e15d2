#pragma once
// What ./course advise answers about springs, computed: apart from how it is told, as both take long to compile.

#include <vector>

#include "advise_recommend.hpp"

#include "commands.hpp"

namespace course {

struct SpringAnswer {
    timestep::SpringScene scene;
    double step;      // or the longest frame, s
    double accuracy;  // percent
    std::vector<timestep::Advice> all;
    timestep::Recommendation take;
};

SpringAnswer answer_spring(const Question& question);

}  // namespace course
