#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    return v + h * (-gravity - k * std::fabs(v) * v);
}
