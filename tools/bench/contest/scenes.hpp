#pragma once
// The scenes of the contest, in the order of the page.

#include <array>

#include "contest.hpp"

namespace contest {

Scene projectile();        // flights.cpp
Scene drag();              // flights.cpp
Scene bouncing_ball();     // flights.cpp
Scene spring();            // springs.cpp
Scene damped_spring();     // springs.cpp
Scene spring_3d();         // springs.cpp
Scene stiff_spring();      // springs.cpp
Scene two_time_scales();   // springs.cpp
Scene dzhanibekov();       // spins.cpp
Scene symmetric_top();     // spins.cpp
Scene capsule_on_plane();  // plane.cpp

struct Named {
    const char* id;
    Scene (*make)();
};
inline constexpr std::array all_scenes{
    Named{"projectile", projectile},
    Named{"drag", drag},
    Named{"spring", spring},
    Named{"damped_spring", damped_spring},
    Named{"spring_3d", spring_3d},
    Named{"stiff_spring", stiff_spring},
    Named{"two_time_scales", two_time_scales},
    Named{"bouncing_ball", bouncing_ball},
    Named{"dzhanibekov", dzhanibekov},
    Named{"symmetric_top", symmetric_top},
    Named{"capsule_on_plane", capsule_on_plane},
};

}  // namespace contest
