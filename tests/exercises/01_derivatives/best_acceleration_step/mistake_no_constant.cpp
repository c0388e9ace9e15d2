#include "exercise.hpp"

double best_acceleration_step(double noise, double snap) {
    return std::pow(4 * noise / snap, 1.0 / 4);
}
