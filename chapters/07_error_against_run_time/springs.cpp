// Five springs. All have an exact solution.

#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>

#include "entries.hpp"
#include "peers.hpp"
#include "scenes.hpp"

using namespace timestep;

namespace contest {

namespace {

constexpr double hertz = 2 * 3.141592653589793;  // rad/s

template <class Model, class X>
Scene scene(const std::string& id, const std::string& title, double size, const Model& model,
            const State<X>& start) {
    Scene scene{id, title, size};
    scene.reference = at_the_marks([&](double t) { return model.exact(start, t); });
    enter_methods(scene, model, start);
    enter_peers(scene, model, start);
    return scene;
}

}  // namespace

// Twice: the second time in float, to show its floor.
Scene spring() {
    Scene spring =
        scene("spring", "a spring, one swing a second", 1, Spring(hertz), State{0, 1.0, 0.0});
    const Spring single(static_cast<float>(hertz));
    const State start{0.0f, 1.0f, 0.0f};
    spring.entries.push_back(entry(verlet, single, start, "Timestep, float"));
    spring.entries.push_back(entry(runge_kutta_4, single, start, "Timestep, float"));
    return spring;
}

Scene damped_spring() {
    return scene("damped_spring", "the same spring, damped (ζ = 0.1)", 1, DampedSpring(hertz, 0.1),
                 State{0, 1.0, 0.0});
}

Scene spring_3d() {
    const State start{0, Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0.6 * hertz, 0.2 * hertz)};
    return scene("spring_3d", "a ball on an elastic in space", 1, Spring(hertz), start);
}

Scene stiff_spring() {
    return scene("stiff_spring", "a stiff spring, ω = 100 rad/s", 1, Spring(100.0),
                 State{0, 1.0, 0.0});
}

// A heavy mass on a soft spring carries a light one on a hard spring. Almost all of the motion is
// slow.
Scene two_time_scales() {
    const CoupledSprings row(Eigen::Vector2d(1, 0.01), Eigen::Vector3d(hertz * hertz, 1e4, 0));
    const Eigen::Vector2d slow = row.modes().col(0) / row.modes()(0, 0);
    const Eigen::Vector2d fast = row.modes().col(1) / row.modes().col(1).norm();
    const State start{0, Eigen::Vector2d(slow + 1e-3 * fast), Eigen::Vector2d(0, 0)};
    return scene("two_time_scales", "a slow swing, and a fast shiver of a thousandth of it", 1, row,
                 start);
}

}  // namespace contest
