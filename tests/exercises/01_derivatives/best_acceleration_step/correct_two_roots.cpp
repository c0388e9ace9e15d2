#include "exercise.hpp"

double best_acceleration_step(double noise, double snap) {
    return std::sqrt(std::sqrt(48 * noise / snap));
}
