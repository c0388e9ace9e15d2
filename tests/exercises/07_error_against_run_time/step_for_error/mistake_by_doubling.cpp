#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    while (error > wanted) {
        h /= 2;
        error /= std::exp2(order);
    }
    while (error * std::exp2(order) <= wanted) {
        h *= 2;
        error *= std::exp2(order);
    }
    return h;
}
