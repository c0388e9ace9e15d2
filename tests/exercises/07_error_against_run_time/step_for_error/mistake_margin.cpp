#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    return 0.9 * h * std::pow(wanted / error, 1.0 / order);
}
