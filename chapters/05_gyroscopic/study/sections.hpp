#pragma once
// What the parts of chapter 5's program share.

#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "lab.hpp"

inline constexpr double pi = std::numbers::pi;

struct Settings {
    double step = 1.0 / 60;  // s
    double spin = 10;        // rad/s, of the tumbling box
    double tilt = 1e-3;      // rad/s, what it spins about its other two axes
};

using Box = timestep::PrincipalInertia<double>;
using Round = timestep::SymmetricInertia<double>;

// A way to treat the gyroscopic torque, one type for all of them: each is compiled for a box and
// for a capsule once, in solvers.cpp, and every section calls it there.
struct Solver {
    using State = timestep::RigidState<double>;
    using V = timestep::Vector3<double>;

    std::string key;   // in the data files and numbers; that of style.gp
    std::string name;  // in tables
    State (*turn_box)(const Box&, const State&, double h);
    State (*turn_round)(const Round&, const State&, double h);
    State (*drive_box)(const Box&, const State&, const V& torque, double h);

    // One step of `h` seconds, without a torque from outside and with one.
    State turn(const Box& inertia, const State& s, double h) const { return turn_box(inertia, s, h); }
    State turn(const Round& inertia, const State& s, double h) const { return turn_round(inertia, s, h); }
    State turn(const Box& inertia, const State& s, const V& torque, double h) const {
        return drive_box(inertia, s, torque, h);
    }
};
const std::vector<Solver>& solvers();          // all, in the order in which the course meets them
const Solver& solver(const std::string& key);  // explicit, dropped, lagged_inertia, implicit, converged, passive

// Compiled there, too.
extern template class timestep::ExactFreeBody<double>;
extern template double timestep::kinetic_energy(const Box&, const timestep::RigidState<double>&);
extern template double timestep::kinetic_energy(const Round&, const timestep::RigidState<double>&);
extern template timestep::Vector3<double> timestep::angular_momentum(const Box&, const timestep::RigidState<double>&);
extern template timestep::Vector3<double> timestep::angular_momentum(const Round&, const timestep::RigidState<double>&);

// A body at rest in its own axes, turning with `omega`, rad/s.
inline timestep::RigidState<double> spinning(double x, double y, double z) {
    return {0, timestep::Quaternion<double>::Identity(), {x, y, z}};
}

// Steps `inertia` from `start`, and calls observe(state) with the start and after each step until
// it returns false.
template <class Inertia>
void spin_on(const Solver& solver, const Inertia& inertia, timestep::RigidState<double> state, double h, long steps,
             const std::function<bool(const timestep::RigidState<double>&)>& observe) {
    for (long n = 0; observe(state) && n < steps; ++n) state = solver.turn(inertia, state, h);
}

void torque(const Settings&, lab::Findings&);            // torque.cpp
void orientation(const Settings&, lab::Findings&);       // torque.cpp
void between_steps(const Settings&, lab::Findings&);     // between.cpp
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
