#pragma once
// What the parts of chapter 8's program share.

#include <timestep/rigid/shapes.hpp>

#include "lab.hpp"
#include "methods.hpp"

struct Settings {
    double step = 1.0 / 60;  // s
    double spin = 10;        // rad/s, of the box about its middle axis
    double tilt = 1e-3;      // rad/s, what it spins about its other two axes
};

void one_token(const Settings&, lab::Findings&);    // one_token.cpp
void orders(const Settings&, lab::Findings&);       // orders.cpp
void fails(const Settings&, lab::Findings&);        // fails.cpp
void minute(const Settings&, lab::Findings&);       // minute.cpp
void work(const Settings&, lab::Findings&);         // work.cpp
void throws(const Settings&, lab::Findings&);       // throws.cpp
void contacts(const Settings&, lab::Findings&);     // contacts.cpp
void runge_kutta(const Settings&, lab::Findings&);  // runge_kutta.cpp
void many(const Settings&, lab::Findings&);         // many.cpp
void demo(const Settings&, lab::Findings&);         // demo.cpp
void engines(lab::Findings&);                       // engines.cpp, of the appendix
