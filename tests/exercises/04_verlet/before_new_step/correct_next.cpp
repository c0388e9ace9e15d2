#include "exercise.hpp"

// The chapter's step for changing steps says where the next position is to be: plain Verlet's
// formula, solved for the position before, leads there.
double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double next = now + (now - before) * h_new / h_old + h_new * (h_old + h_new) / 2 * a;
    return 2 * now - next + h_new * h_new * a;
}
