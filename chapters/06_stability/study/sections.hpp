#pragma once
// What the parts of chapter 6's program share.

#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <string>

#include "lab.hpp"

inline constexpr double pi = std::numbers::pi;

// "× 1.5": what is left of something, in two digits, and in plain ones up to a million.
inline std::string times(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    if (value >= 99.5 && value < 1e6) std::snprintf(text, sizeof text, "%.0f", std::strtod(text, nullptr));
    return std::string("× ") + text;
}

struct Settings {
    double step = 1.0 / 60;  // s
    double omega = 100;      // rad/s
    double zeta = 0.05;      // damping ratio
};

void your_spring(const Settings&, lab::Findings&);        // advice.cpp
void definitions(const Settings&, lab::Findings&);        // definitions.cpp
void regions(const Settings&, lab::Findings&);            // regions.cpp
void stiff_decay(const Settings&, lab::Findings&);        // stiff_decay.cpp
void boundary(const Settings&, lab::Findings&);           // boundary.cpp
void stiff_springs(const Settings&, lab::Findings&);      // stiff_springs.cpp
void two_scales(const Settings&, lab::Findings&);         // two_scales.cpp
void kicks(const Settings&, lab::Findings&);              // kicks.cpp
void velocity_forces(const Settings&, lab::Findings&);    // velocity_forces.cpp
void cures(const Settings&, lab::Findings&);              // cures.cpp
void prothero_robinson(const Settings&, lab::Findings&);  // prothero.cpp
void reactions(const Settings&, lab::Findings&);          // reactions.cpp
void cloth(const Settings&, lab::Findings&);              // cloth.cpp
void extreme_inputs(const Settings&, lab::Findings&);     // extremes.cpp
void advice(const Settings&, lab::Findings&);             // advice.cpp
void advice_bodies(const Settings&, lab::Findings&);      // advice_bodies.cpp
void leave_out(const Settings&, lab::Findings&);          // leave_out.cpp
