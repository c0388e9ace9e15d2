#pragma once
// The parts of chapter 1's program. Each writes its data, its numbers and its checks.

#include <string>

#include "lab.hpp"

struct Settings {
    std::string function = "exp";
    double at = 1;
    double step = 0.1;
    double grid = 0.004;  // m
    double rate = 60;     // frames a second
};

void frames(const Settings& settings, lab::Findings& out);      // hand.cpp: velocity from positions
void curves(const Settings& settings, lab::Findings& out);      // curves.cpp: tangents and chords
void orders(const Settings& settings, lab::Findings& out);      // orders.cpp: how fast errors fall
void best_steps(const Settings& settings, lab::Findings& out);  // best_steps.cpp: where they stop
void taylor_series(lab::Findings& out);                         // series.cpp: polynomials for a sine
void mistakes(const Settings& settings, lab::Findings& out);    // break_it.cpp: break it
