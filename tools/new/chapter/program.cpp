// Chapter NEW_NUMBER: a ball falls for a second. How large is the error at the end?
//
//   c++ -std=c++20 -O2 -Iinclude chapters/NEW_CHAPTER/NEW_NAME.cpp -o fall && ./fall

#include <fstream>
#include <iostream>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/models/projectile.hpp>

using namespace timestep;

// Change these. FILL IN: your own numbers, and below them your program. It prints what it finds and writes one file of
// data, from which figures.gp draws.
const double gravity = -9.81;  // m/s²
const double h = 1.0 / 10;     // s: the step
const int steps = 10;          // one second

int main() {
    const Projectile ball(gravity);
    const State start{0, 0.0, 0.0};  // t, x, v: at rest
    std::ofstream data("fall.dat");
    data << "# time stepped exact\n";

    State state = start;
    for (int n = 0; n <= steps; ++n) {
        data << state.t << ' ' << state.x << ' ' << ball.exact(start, state.t).x << '\n';
        if (n < steps) state = explicit_euler.step(ball, state, h);
    }

    const double exact = ball.exact(start, state.t).x;
    std::cout << "After " << state.t << " s the ball is at " << state.x << " m; exact is " << exact << " m.\n";
    if (!data.flush()) return std::cerr << "fall.dat: cannot be written\n", 2;
}
