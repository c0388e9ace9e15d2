#pragma once
// Bullet's and ODE's bodies, turning freely, where CMake has found them.

#include <string>

#include <timestep/rigid/body.hpp>

#include "contest.hpp"

namespace contest {

using Start = timestep::RigidState<double>;
using Moments = timestep::PrincipalInertia<double>;

// Neither library uses two equal moments. Where our solvers do, `which` says that theirs do not: ", three moments".
void enter_bullet(Scene& scene, const Moments& inertia, const Start& start, const std::string& which);
void enter_ode(Scene& scene, const Moments& inertia, const Start& start, const std::string& which);

}  // namespace contest
