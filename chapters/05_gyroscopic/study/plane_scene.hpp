#pragma once
// The bodies and throws of the scenes on a plane, and the list of variants.

#include <cmath>
#include <random>
#include <string>

#include <timestep/gyroscopic/converged_gyroscopic.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/no_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/plane.hpp>
#include <timestep/rigid/shapes.hpp>

namespace scene {

namespace plane = timestep::plane;

// Calls `use(key, name, solver)` for each; the key is that of style.gp.
template <class Use>
void for_each_variant(const Use& use) {
    const auto one = [&](const std::string& key, const auto& solver) { use(key, solver.name, solver); };
    one("explicit", timestep::explicit_gyroscopic);
    one("dropped", timestep::no_gyroscopic);
    one("lagged_inertia", timestep::lagged_inertia);
    one("implicit", timestep::implicit_gyroscopic);
    one("converged", timestep::converged_gyroscopic);
    one("passive", timestep::passive_gyroscopic);
}

inline constexpr double spin = 40;  // rad/s: six turns and a bit in a second

// 90 cm long, 30 cm thick, 1 kg.
inline plane::Capsule<timestep::SymmetricInertia<double>> capsule() {
    return {timestep::capsule(1.0, 0.15, 0.6), 1.0, 0.15, 0.3};
}

inline plane::Capsule<timestep::UniformInertia<double>> ball() { return {timestep::sphere(1.0, 0.15), 1.0, 0.15, 0.0}; }

inline plane::Ground ground(double rolling, plane::Arms arms = plane::Arms::middle) {
    return {9.81, 0.5, rolling, arms};
}

// On one end, a twentieth of a radian off upright; the spin halfway between its axis and the plane.
template <class Inertia>
plane::BodyState thrown(const plane::Capsule<Inertia>& body) {
    const plane::Orientation q(Eigen::AngleAxisd(0.05, plane::V::UnitX()));
    const plane::V axis = q * plane::V::UnitZ();
    return placed(body, q, spin * (axis + plane::V::UnitY()).normalized());
}

// Any orientation, any axis of spin, from half a metre up.
template <class Inertia>
plane::BodyState random_throw(const plane::Capsule<Inertia>& body, std::mt19937& random) {
    // Directions from a cube, with the corners thrown away: the same numbers with every compiler.
    const auto direction = [&](auto v) {
        do
            for (auto& x : v) x = 2 * (static_cast<double>(random()) / 4294967296.0) - 1;
        while (!(v.squaredNorm() <= 1 && v.squaredNorm() > 0.01));
        return decltype(v)(v.normalized());
    };
    const Eigen::Vector4d q = direction(Eigen::Vector4d());
    const plane::V axis = direction(plane::V());
    return placed(body, plane::Orientation(q), spin * axis, 0.5);
}

}  // namespace scene
