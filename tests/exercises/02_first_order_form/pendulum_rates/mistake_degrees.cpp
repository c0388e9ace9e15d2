#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double x = s.x * std::numbers::pi / 180;
    return {s.v, -g / length * std::sin(x) - drag * length * std::abs(s.v) * s.v};
}
