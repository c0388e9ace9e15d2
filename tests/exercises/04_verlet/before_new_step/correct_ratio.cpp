#include "exercise.hpp"

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double ratio = h_new / h_old;
    return (1 - ratio) * now + ratio * before + (h_new - h_old) * h_new * a / 2;
}
