#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    const double C = error / std::pow(h, order);
    return std::pow(wanted / C, 1.0 / order);
}
