#pragma once
// What is counted. Each source of this folder hands out its cases; study.cpp has callgrind count them.

#include <functional>
#include <string>
#include <vector>

struct Case {
    std::string name;
    long few;                         // It is counted with so many steps, and with twice as many.
    std::function<void(long)> steps;  // takes so many steps
};

std::vector<Case> methods_and_scenes();  // steps.cpp
std::vector<Case> gyroscopic_solvers();  // gyroscopic.cpp
std::vector<Case> bodies_and_rope();     // bodies.cpp
std::vector<Case> crowds();              // bodies.cpp
std::vector<Case> functions_for_c();     // gyroscopic.cpp

// A number that the compiler does not know: 1. And where results go, or the compiler would leave out the steps.
inline volatile double unknown_one = 1, kept;
