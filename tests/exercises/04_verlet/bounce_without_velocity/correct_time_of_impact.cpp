#include "exercise.hpp"

// The film of the step: down to the floor, and up for the part of the step that is left. Time is
// counted in steps.
std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now < floor) {
        const double v = now - before, impact = (floor - before) / v;
        const double v_up = -e * v;
        now = floor + (1 - impact) * v_up;
        before = now - v_up;
    }
    return {before, now};
}
