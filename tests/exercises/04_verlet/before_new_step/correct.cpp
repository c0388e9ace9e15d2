#include "exercise.hpp"

namespace next {

// The chapter's step for changing steps says where the next position is to be: plain Verlet's
// formula, solved for the position before, leads there.
double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double next = now + (now - before) * h_new / h_old + h_new * (h_old + h_new) / 2 * a;
    return 2 * now - next + h_new * h_new * a;
}

}  // namespace next

namespace ratio {

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double ratio = h_new / h_old;
    return (1 - ratio) * now + ratio * before + (h_new - h_old) * h_new * a / 2;
}

}  // namespace ratio

namespace time_between_middles {

// Velocities belong to the middles of the steps; from one middle to the other lies half of the
// difference of the steps.
double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double v_middle_old = (now - before) / h_old;
    const double v_middle_new = v_middle_old + (h_old - h_new) / 2 * a;
    return now - h_new * v_middle_new;
}

}  // namespace time_between_middles

namespace through_three_places {

// The parabola through the last place, this one and the one that a step as long as before would lead to.
double before_new_step(double before, double now, double a, double h_old, double h_new) {
    const double after = 2 * now - before + h_old * h_old * a, s = -h_new / h_old;
    return before * s * (s - 1) / 2 + now * (1 - s) * (1 + s) + after * s * (s + 1) / 2;
}

}  // namespace through_three_places
