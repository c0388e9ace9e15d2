#pragma once
// What ./course advise answers about a body, computed: apart from how it is told, as both take long to compile.

#include <string>
#include <vector>

#include "advise_body.hpp"
#include <timestep/nearly_symmetric.hpp>

#include "commands.hpp"

namespace course {

struct BodyAnswer {
    double spin, step;  // |ω|, and the longest frame
    bool even;          // are all frames as long?
    std::vector<timestep::BodyAdvice> all;
    bool tilted;     // was the throw off its axis by less than a hundredth?
    double seconds;  // how long it was watched
    timestep::Thrown truth;
    timestep::ClosestMoments closest;
    bool all_but_equal;         // two different moments so close that the difference is a nuisance; not all three
    int axis;                   // see axis_of_revolution()
    timestep::Thrown declared;  // the throw if they were declared equal, or are
    double half_gone;           // see half_gone_by_passive()
    timestep::BodyRecommendation take;
    timestep::Thrown taken;  // the throw by what is recommended
};

BodyAnswer answer_body(const Question& question);

}  // namespace course
