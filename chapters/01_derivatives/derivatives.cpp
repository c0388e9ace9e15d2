// Chapter 1: the slope of a known function from two of its values. Which two, and how far apart?
//
//   c++ -std=c++20 -O2 -Iinclude chapters/01_derivatives/derivatives.cpp -o slopes && ./slopes

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

#include <timestep/differences.hpp>

using namespace timestep;

// Play with these.
const auto f = [](double t) { return std::sin(t); };      // a position, m
const auto slope = [](double t) { return std::cos(t); };  // and its velocity, by hand, m/s
const double t = 1;                                       // where we look, s
const int halvings = 16;                                  // steps of 1, 1/2, 1/4 … s

int main() {
    std::ofstream data("slopes.dat");
    data << "# step forward backward central\n";
    std::printf("%12s %12s %12s %12s\n", "step", "forward", "backward", "central");

    double h = 1;
    for (int n = 0; n <= halvings; ++n) {
        // Look ahead, look back, or do both: which is off by how much?
        const double forward = forward_difference(f, t, h) - slope(t);
        const double backward = backward_difference(f, t, h) - slope(t);
        const double central = central_difference(f, t, h) - slope(t);

        data << h << ' ' << std::abs(forward) << ' ' << std::abs(backward) << ' ' << std::abs(central) << '\n';
        std::printf("%12.3g %12.3g %12.3g %12.3g\n", h, forward, backward, central);
        h /= 2;
    }
    std::cout << "Half the step: half the error to one side, a quarter of it in the middle,\n"
              << "until the rounding of f is larger.\n";
    if (!data.flush()) return std::cerr << "slopes.dat: cannot be written\n", 2;
}
