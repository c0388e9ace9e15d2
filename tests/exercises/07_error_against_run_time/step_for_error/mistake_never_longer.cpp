#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    return h * std::min(1.0, std::pow(wanted / error, 1.0 / order));
}
