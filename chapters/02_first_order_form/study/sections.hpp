#pragma once
// What the parts of chapter 2's program share: its options, and the scenes they describe.

#include <numbers>
#include <string>

#include <Eigen/Core>

#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/scene.hpp>

#include "lab.hpp"

using timestep::Drag, timestep::Projectile, timestep::Scene;
using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;

inline constexpr double pi = std::numbers::pi;
inline constexpr double gravity = 9.81;    // m/s²
inline constexpr double leg = 1;           // m: the character's legs at rest length
inline constexpr double dip = 0.25;        // m: how far a spring is pulled out before it is let go
inline constexpr double throw_speed = 30;  // m/s: the grenade leaves the hand at 45°

struct Settings {
    double mass = 80;            // kg, the character
    double stiffness = 5120;     // N/m, its legs
    double damping = 128;        // N·s/m
    double terminal_speed = 40;  // m/s, the grenade's in a long fall
    double step = 1.0 / 60;      // s, the fixed step
    std::string method = "explicit_euler";

    double omega() const { return legs().omega; }
    double zeta() const { return legs().zeta; }
    double period() const { return 2 * pi / omega(); }

    timestep::DampedSpring<double> legs() const {
        return timestep::DampedSpring<double>::from_stiffness(stiffness, damping, mass);
    }
};

/// [scenes]
// x is the height of the hip above its place at rest length.
inline auto character(const Settings& settings) { return Scene{settings.legs(), Projectile{-gravity}}; }

inline auto grenade(const Settings& settings) {
    const double v = settings.terminal_speed;
    const double k = gravity / (v * v);
    return Scene{Projectile{Vector2(0, -gravity)}, Drag{k}};
}
/// [scenes]

inline timestep::State<Vector2> throw_grenade() {
    const double v = throw_speed / std::sqrt(2.0);
    return {0, Vector2(0, 0), Vector2(v, v)};
}

// In the order of the account:
void solutions(const Settings&, lab::Findings&);      // equations whose answer we know
void portrait(const Settings&, lab::Findings&);       // the spring and its phase portrait
void damping(const Settings&, lab::Findings&);        // ζ below, at and above 1
void arrays(const Settings&, lab::Findings&);         // several bodies, one solver
void hard_problems(const Settings&, lab::Findings&);  // drag, and a tether in space
void game_loop(const Settings&, lab::Findings&);      // frames and steps
void break_it(const Settings&, lab::Findings&);       // what goes wrong, on purpose
void other_bits(const Settings&, lab::Findings&);     // the same program, other bits; places far away
