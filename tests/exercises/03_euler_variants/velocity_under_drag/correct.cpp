#include "exercise.hpp"

namespace cases {

// Up and down as two cases, and thin air by a series.
double velocity_under_drag(double v, double gravity, double k, double h) {
    v -= h * gravity;
    const bool rises = v > 0;
    const double size = rises ? v : -v;
    const double q = h * k * size;  // how much of the speed the old drag would take
    double left;
    if (q < 1e-4)
        left = 1 - q + 2 * q * q - 5 * q * q * q;
    else
        left = (std::sqrt(1 + 4 * q) - 1) / (2 * q);
    return rises ? left * size : -left * size;
}

}  // namespace cases

namespace newton {

// Newton-Raphson from the velocity without drag: the equation is convex on the way, so the iterates
// fall towards the root from one side and do not miss it.
double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity, size = std::fabs(w), q = h * k;
    double s = size;
    for (int i = 0; i < 60; ++i) s -= (s + q * s * s - size) / (1 + 2 * q * s);
    return std::copysign(s, w);
}

}  // namespace newton

namespace newton_on_the_equation {

// As the equation stands, from the old velocity, without a thought for gravity apart: where gravity uses up all of v,
// what is left is roundoff of v.
double velocity_under_drag(double v, double gravity, double k, double h) {
    double x = v;
    for (int i = 0; i < 100; ++i) {
        const double missing = x - v + h * (gravity + k * std::fabs(x) * x);
        x -= missing / (1 + 2 * h * k * std::fabs(x));
    }
    return x;
}

}  // namespace newton_on_the_equation

namespace nearly {

// As far off as the task allows, and not farther.
double velocity_under_drag(double v, double gravity, double k, double h) {
    v -= h * gravity;
    return (1 + 4e-10) * 2 * v / (1 + std::sqrt(1 + 4 * h * k * std::fabs(v)));
}

}  // namespace nearly
