// Chapter 6: the longest step that a spring survives, by trying and by formula.
//
//   c++ -std=c++20 -O2 -Iinclude chapters/06_stability/stability.cpp -o longest && ./longest

#include <cmath>
#include <fstream>
#include <iostream>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/midpoint.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/stability_limit.hpp>

using namespace timestep;

// Play with these.
const int steps = 10000;    // so long we watch
const double least = 0.01;  // damping ratio: from next to none
const double most = 10;     // to a lot

const double omega = 100;  // rad/s: whichever it is, only omega h counts

// Does it swing farther in the end than at the start?
template <class Method>
bool grows(const Method& method, double zeta, double h) {
    const DampedSpring spring(omega, zeta);
    State state{0, 1.0, 0.0};
    double size = 1;
    for (int n = 0; n < steps && size < 1e6; ++n) {
        state = method.step(spring, state, h);
        size = std::hypot(state.x, state.v / omega);
    }
    return size > 1;
}

// Halve the gap between a step that holds and one that does not, until nothing is left of it.
template <class Method>
double longest_step(const Method& method, double zeta) {
    double holds = 0, breaks = 10 * (1 + zeta) / omega;  // longer than any of them takes
    for (int n = 0; n < 30; ++n) {
        const double h = (holds + breaks) / 2;
        (grows(method, zeta, h) ? breaks : holds) = h;
    }
    return holds;
}

int main() {
    std::ofstream data("longest.dat");
    const auto look_at = [&](const auto& method) {
        data << "# " << method.name << '\n';
        std::cout << method.name << '\n';
        for (int i = 0; i <= 39; ++i) {
            const double zeta = least * std::pow(most / least, i / 39.0);
            const double tried = omega * longest_step(method, zeta);
            const double formula = stability_limit(method, zeta).value;
            data << zeta << ' ' << tried << ' ' << formula << '\n';
            if (i % 13 == 0)
                std::cout << "  zeta " << zeta << ": omega h up to " << tried << ", by formula " << formula << '\n';
        }
        data << "\n\n";
    };
    look_at(explicit_euler);
    look_at(semi_implicit_euler);
    look_at(semi_implicit_euler_new_damping);
    look_at(midpoint);
    look_at(runge_kutta_4);
    if (!data.flush()) return std::cerr << "longest.dat: cannot be written\n", 2;
}
