#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double gravity = -(g / length) * std::sin(s.x);
    const double air = -drag * length * std::copysign(s.v * s.v, s.v);
    return {s.v, gravity + air};
}
