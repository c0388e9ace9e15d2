#pragma once
// What the parts of chapter 4's program share.

#include <cmath>
#include <numbers>
#include <string>

#include <timestep/models/spring.hpp>
#include <timestep/state.hpp>

#include "lab.hpp"

inline constexpr double pi = std::numbers::pi;
inline constexpr double eps = 2.220446049250313e-16;

struct Settings {
    double omega = 10;       // rad/s, the spring of the first picture
    double step = 1.0 / 60;  // s
    long steps = 120;
    long sweeps = 8;  // over the rope's links, in its first line of print

    double wh() const { return omega * step; }
};

inline double distance(const timestep::State<double>& a, const timestep::State<double>& b) {
    return std::hypot(a.x - b.x, a.v - b.v);
}

void two_positions(const Settings&, lab::Findings&);    // two_positions.cpp
void constant_force(const Settings&, lab::Findings&);   // constant_force.cpp
void three_forms(const Settings&, lab::Findings&);      // three_forms.cpp
void changing_steps(const Settings&, lab::Findings&);   // changing_steps.cpp
void demos(const Settings&, lab::Findings&);            // demos.cpp
void ropes(const Settings&, lab::Findings&);            // ropes.cpp
void compliant_ropes(const Settings&, lab::Findings&);  // compliance.cpp
void costs(const Settings&, lab::Findings&);            // costs.cpp
