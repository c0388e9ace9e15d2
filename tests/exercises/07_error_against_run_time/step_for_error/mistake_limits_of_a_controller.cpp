#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::clamp(std::pow(wanted / error, 1.0 / order), 0.2, 5.0);
}
