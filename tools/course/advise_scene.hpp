#pragma once
// ./course advise: the springs of a question.

#include <timestep/advise.hpp>

#include "advise.hpp"

namespace course {

timestep::SpringScene scene_of(const Question& question);

}  // namespace course
