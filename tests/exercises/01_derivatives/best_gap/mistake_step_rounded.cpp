#include "exercise.hpp"

int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double step = std::cbrt(3 * noise / jerk) / frame;
    return static_cast<int>(std::clamp(std::round(step), 1.0, 1.0 * most));
}
