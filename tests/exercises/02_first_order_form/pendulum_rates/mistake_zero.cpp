#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    return {0, 0};
}
