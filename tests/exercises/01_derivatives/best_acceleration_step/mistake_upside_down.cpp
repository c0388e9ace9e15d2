#include "exercise.hpp"

double best_acceleration_step(double noise, double snap) {
    return std::pow(snap / (48 * noise), 1.0 / 4);
}
