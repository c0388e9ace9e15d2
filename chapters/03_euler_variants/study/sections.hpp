#pragma once
// What the parts of chapter 3's program share.

#include <cmath>
#include <numbers>
#include <string>

#include <timestep/models/spring.hpp>
#include <timestep/state.hpp>

#include "lab.hpp"

inline constexpr double pi = std::numbers::pi;

struct Settings {
    double omega = 10;       // rad/s, the spring of all pictures
    double step = 1.0 / 60;  // s
    long steps = 120;
    std::string method = "all";  // draw only this one

    double wh() const { return omega * step; }
    bool wants(const std::string& name) const { return method == "all" || method == lab::id(name); }
};

// Position and velocity over ω have the same unit, so a state is a point in a plane and its
// distance from the origin is the amplitude of the swing.
inline double amplitude(const timestep::State<double>& s, double omega) { return std::hypot(s.x, s.v / omega); }

void portraits(const Settings&, lab::Findings&);         // portraits.cpp
void energies(const Settings&, lab::Findings&);          // energy.cpp
void eigenvalue_paths(const Settings&, lab::Findings&);  // eigenvalues.cpp
void matrices(const Settings&, lab::Findings&);          // matrices.cpp
void areas(const Settings&, lab::Findings&);             // areas.cpp
void sweep(const Settings&, lab::Findings&);             // sweep.cpp
void damping(const Settings&, lab::Findings&);           // damping.cpp
void dampers(const Settings&, lab::Findings&);           // dampers.cpp
void soft_constraints(const Settings&, lab::Findings&);  // soft.cpp
void orders(const Settings&, lab::Findings&);            // orders.cpp
void costs(const Settings&, lab::Findings&);             // costs.cpp
void bounces(const Settings&, lab::Findings&);           // bounces.cpp
