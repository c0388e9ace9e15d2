#pragma once
// A spring as a scene: all of them have an exact solution.

#include <numbers>

#include "entries.hpp"
#include "peers.hpp"
#include "scenes.hpp"

namespace contest {

inline constexpr double hertz = 2 * std::numbers::pi;  // rad/s

template <class Model, class X>
Scene spring_scene(const std::string& id, const std::string& title, double size, const Model& model,
                   const timestep::State<X>& start) {
    Scene scene{id, title, size};
    scene.reference = at_the_marks([&](double t) { return model.exact(start, t); });
    enter_methods(scene, model, start);
    enter_peers(scene, model, start);
    return scene;
}

}  // namespace contest
