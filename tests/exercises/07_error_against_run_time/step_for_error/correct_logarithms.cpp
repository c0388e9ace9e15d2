#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    // Along the straight line of the diagram.
    const double slope = order;
    return std::exp(std::log(h) + (std::log(wanted) - std::log(error)) / slope);
}
