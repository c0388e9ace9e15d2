#pragma once
// ./course advise: the springs of a question.

#include "advise_verdict.hpp"

#include "commands.hpp"

namespace course {

timestep::SpringScene scene_of(const Question& question);

}  // namespace course
