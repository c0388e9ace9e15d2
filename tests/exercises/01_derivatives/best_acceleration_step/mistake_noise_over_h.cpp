#include "exercise.hpp"

double best_acceleration_step(double noise, double snap) {
    return std::cbrt(24 * noise / snap);
}
