#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {s.v, (-g * std::sin(s.x) - drag * std::abs(s.v) * s.v) / length};
}
