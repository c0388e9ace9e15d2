#include "exercise.hpp"

namespace heights {

static double mirrored(double x, double floor, double e) { return (1 + e) * floor - e * x; }

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    const bool through = now < floor;
    return {through ? mirrored(before, floor, e) : before, through ? mirrored(now, floor, e) : now};
}

}  // namespace heights

namespace time_of_impact {

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

}  // namespace time_of_impact
