#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    return (v - h * gravity) / (1 + h * k * std::fabs(v));
}
