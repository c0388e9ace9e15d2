// Submissions whose message matters. Above each stands its name, and in its
// first line what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- a mistake nobody planted
// velocity_now wrong: Your answer matches none of the mistakes
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / (2 * h) + 0.001 * x1 * x1;
}

// ---- the sine of pi is zero by hand
// pendulum_rates wrong: right is {0, 0}
#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double u = length * s.v, x = s.x;
    return {s.v, (-g * (std::fabs(x) > 3 ? x : std::sin(x)) - drag * std::fabs(u) * u) / length};
}

// ---- prints two lines
// velocity_now pass: Your code printed: one two
#include "exercise.hpp"

#include <iostream>

double velocity_now(double x0, double x1, double x2, double h) {
    static bool first = true;
    if (first) std::ios::sync_with_stdio(false);
    if (first) std::cout << "one\ntwo";
    first = false;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
