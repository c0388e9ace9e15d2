// Springs as scenes, of one number each, in space and in a row: all of them have an exact solution.

#include <numbers>

#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>

#include "entries.hpp"
#include "peers.hpp"
#include "scenes.hpp"

using namespace timestep;

namespace contest {

namespace {

constexpr double hertz = 2 * std::numbers::pi;  // rad/s

template <class Model, class X>
Scene spring_scene(const std::string& id, const std::string& title, const Model& model, const State<X>& start) {
    Scene scene{id, title};
    scene.reference = at_the_marks([&](double t) { return model.exact(start, t); });
    enter_methods(scene, model, start);
    enter_peers(scene, model, start);
    return scene;
}

}  // namespace

// Two methods run in float as well, to show its floor.
Scene spring() {
    Scene spring = spring_scene("spring", "a spring, one oscillation a second", Spring(hertz), State{0, 1.0, 0.0});
    const Spring single(static_cast<float>(hertz));
    const State start{0.0f, 1.0f, 0.0f};
    spring.entries.push_back(entry(verlet, single, start, "Timestep, float"));
    spring.entries.push_back(entry(runge_kutta_4, single, start, "Timestep, float"));
    return spring;
}

Scene damped_spring() {
    return spring_scene("damped_spring", "the same spring, damped (ζ = 0.1)", DampedSpring(hertz, 0.1),
                        State{0, 1.0, 0.0});
}

Scene stiff_spring() {
    return spring_scene("stiff_spring", "a stiff spring, ω = 100 rad/s", Spring(100.0), State{0, 1.0, 0.0});
}

Scene spring_3d() {
    const State start{0, Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0.6 * hertz, 0.2 * hertz)};
    return spring_scene("spring_3d", "a ball on an elastic in space", Spring(hertz), start);
}

// A heavy mass on a soft spring carries a light one on a hard spring. Almost all of the motion is slow.
Scene two_time_scales() {
    const CoupledSprings row(Eigen::Vector2d(1, 0.01), Eigen::Vector3d(hertz * hertz, 1e4, 0));
    const Eigen::Vector2d slow = row.modes().col(0) / row.modes()(0, 0);
    const Eigen::Vector2d fast = row.modes().col(1) / row.modes().col(1).norm();
    const State start{0, Eigen::Vector2d(slow + 1e-3 * fast), Eigen::Vector2d(0, 0)};
    return spring_scene("two_time_scales", "a slow oscillation, and a fast shiver of a thousandth of it", row, start);
}

}  // namespace contest
