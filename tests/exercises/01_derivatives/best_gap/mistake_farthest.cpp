#include "exercise.hpp"

int best_gap(double frame, double noise, double jerk, int most) {
    return most;
}
