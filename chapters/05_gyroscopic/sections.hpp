#pragma once
// What the parts of chapter 5's program share.

#include <string>
#include <vector>

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "lab.hpp"

inline constexpr double pi = 3.141592653589793;

struct Settings {
    double step = 1.0 / 60;  // s
    double spin = 10;        // rad/s, of the tumbling box
    double tilt = 1e-3;      // rad/s, what it spins about its other two axes
};

// The name of a solver in the data files and numbers.
inline const char* key(const timestep::ExplicitGyroscopic&) { return "explicit"; }
inline const char* key(const timestep::NoGyroscopic&) { return "dropped"; }
inline const char* key(const timestep::OldInertia&) { return "old_inertia"; }
inline const char* key(const timestep::ImplicitGyroscopic&) { return "implicit"; }
inline const char* key(const timestep::ConvergedGyroscopic&) { return "converged"; }
inline const char* key(const timestep::PassiveGyroscopic&) { return "passive"; }

// A body at rest in its own axes, turning with `omega`, rad/s.
inline timestep::RigidState<double> spinning(double x, double y, double z) {
    return {0, timestep::Quaternion<double>::Identity(), {x, y, z}};
}

// Steps `inertia` from `start`, and calls observe(state) with the start and after each step until it
// returns false.
template <class Solver, class Inertia, class Observe>
void spin_on(const Solver& solver, const Inertia& inertia, timestep::RigidState<double> state,
             double h, long steps, const Observe& observe) {
    for (long n = 0; observe(state) && n < steps; ++n) state = turn(solver, inertia, state, h);
}

void torque(const Settings&, lab::Findings&);            // torque.cpp
void attitude(const Settings&, lab::Findings&);          // torque.cpp
void newton(const Settings&, lab::Findings&);            // newton.cpp
void free_capsule(const Settings&, lab::Findings&);      // capsule.cpp
void uneven_capsule(const Settings&, lab::Findings&);    // capsule.cpp
void staff(const Settings&, lab::Findings&);             // capsule.cpp
void tumble(const Settings&, lab::Findings&);            // tumble.cpp
void minute(const Settings&, lab::Findings&);            // minute.cpp
void energy_map(const Settings&, lab::Findings&);        // energy_map.cpp
void capsule_on_plane(const Settings&, lab::Findings&);  // plane.cpp
void driven_body(const Settings&, lab::Findings&);       // driven.cpp
void films(const Settings&, lab::Findings&);             // films.cpp
