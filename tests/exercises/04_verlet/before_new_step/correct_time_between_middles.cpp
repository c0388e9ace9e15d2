#include "exercise.hpp"

// Velocities belong to the middles of the steps; from one middle to the other lies half of the
// difference of the steps.
double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double v_middle_old = (now - before) / h_old;
    const double v_middle_new = v_middle_old + (h_old - h_new) / 2 * a;
    return now - h_new * v_middle_new;
}
