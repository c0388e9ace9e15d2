// Chapter 3: one spring, three ways to take a step. Which one stays?
//
//   c++ -std=c++20 -O2 -Iinclude chapters/03_euler_variants/euler_variants.cpp -o euler && ./euler

#include <cmath>
#include <fstream>
#include <iostream>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>

using namespace timestep;

// Play with these.
const double omega = 10;    // rad/s: the period is 0.63 s
const double h = 1.0 / 60;  // s: one step a frame
const int frames = 120;     // two seconds

// How far it swings: the distance from the middle of the phase portrait, m.
double amplitude(const State<double>& s) { return std::hypot(s.x, s.v / omega); }

// Steps the spring by one method, and writes where it goes.
template <class Method>
void portrait(const Method& method, std::ofstream& data) {
    const Spring spring(omega);
    State state{0, 1.0, 0.0};  // pulled out by one metre and let go

    data << "# " << method.name << '\n';
    for (int frame = 0; frame < frames; ++frame) {
        data << state.x << ' ' << state.v / omega << '\n';
        state = method.step(spring, state, h);
    }
    data << state.x << ' ' << state.v / omega << "\n\n\n";

    std::cout << method.name << ": amplitude " << amplitude(state) << " m after " << frames * h << " s\n";
}

int main() {
    std::ofstream data("portraits.dat");
    portrait(explicit_euler, data);
    portrait(implicit_euler, data);
    portrait(semi_implicit_euler, data);
    if (!data.flush()) return std::cerr << "portraits.dat: cannot be written\n", 2;
}
