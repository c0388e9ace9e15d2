// velocity_now not_finite: Every answer must be a finite number
#include "exercise.hpp"

double velocity_now(double x0, double x1, double, double h) {
    return std::sqrt(-1 - h) * (x1 - x0);
}
