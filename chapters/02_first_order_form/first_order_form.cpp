// Chapter 2: a ball with drag and a mass on a spring, handed to one solver; and a loop that frames cannot disturb.
//
//   c++ -std=c++20 -O2 chapters/02_first_order_form/first_order_form.cpp -o motion && ./motion

#include <array>
#include <cmath>
#include <fstream>
#include <iostream>

using Array = std::array<double, 2>;  // y = (x, v): where it is, and how fast

// Play with these.
const double drag = 0.02;       // 1/m: how the air brakes the ball
const double speed = 20;        // m/s: it is thrown straight up
const double omega = 3;         // rad/s: the spring, the period is 2.1 s
const double h = 0.017;         // s: the simulation's step
const double frame = 1.0 / 30;  // s: the picture's
const double seconds = 3;       // of game

// Newton's law, as a rate of change: ẋ = v, v̇ = a. That is all that a solver wants to know.
Array ball(const Array& y) { return {y[1], -9.81 - drag * std::abs(y[1]) * y[1]}; }
Array spring(const Array& y) { return {y[1], -omega * omega * y[0]}; }

// A solver: go on for a time h at the rate of now. It knows neither balls nor springs.
template <class Rate>
Array step(const Rate& rate, const Array& y) {
    const Array dy = rate(y);
    return {y[0] + h * dy[0], y[1] + h * dy[1]};
}

int main() {
    std::ofstream data("motion.dat");
    data << "# time height spring exact\n";

    Array thrown{0, speed}, swinging{1, 0};  // m, m/s: the mass is pulled out by one metre and let go
    double owed = 0;                         // time that the picture is ahead of the simulation, s
    const long frames = std::lround(seconds / frame);
    long steps = 0;
    for (long n = 0; n <= frames; ++n) {
        // A frame pays what it owes in whole steps, and keeps the rest for the next one. The first shows the start.
        if (n > 0) owed += frame;
        for (; owed >= h; owed -= h) {
            thrown = step(ball, thrown);
            swinging = step(spring, swinging);
            ++steps;
        }
        const double t = steps * h;
        data << t << ' ' << thrown[0] << ' ' << swinging[0] << ' ' << std::cos(omega * t) << '\n';
    }
    std::cout << frames << " frames, " << steps << " steps, " << owed << " s still owed\n"
              << "the ball is at " << thrown[0] << " m, the mass at " << swinging[0] << " m\n";
    if (!data.flush()) return std::cerr << "motion.dat: cannot be written\n", 2;
}
