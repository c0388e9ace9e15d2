// Three springs of one number each.

#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>

#include "springs.hpp"

using namespace timestep;

namespace contest {

// Two methods run in float as well, to show its floor.
Scene spring() {
    Scene spring = spring_scene("spring", "a spring, one oscillation a second", 1, Spring(hertz), State{0, 1.0, 0.0});
    const Spring single(static_cast<float>(hertz));
    const State start{0.0f, 1.0f, 0.0f};
    spring.entries.push_back(entry(verlet, single, start, "Timestep, float"));
    spring.entries.push_back(entry(runge_kutta_4, single, start, "Timestep, float"));
    return spring;
}

Scene damped_spring() {
    return spring_scene("damped_spring", "the same spring, damped (ζ = 0.1)", 1, DampedSpring(hertz, 0.1),
                        State{0, 1.0, 0.0});
}

Scene stiff_spring() {
    return spring_scene("stiff_spring", "a stiff spring, ω = 100 rad/s", 1, Spring(100.0), State{0, 1.0, 0.0});
}

}  // namespace contest
