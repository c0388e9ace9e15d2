#include "exercise.hpp"

static double mirrored(double x, double floor, double e) {
    return (1 + e) * floor - e * x;
}

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    const bool through = now < floor;
    return {through ? mirrored(before, floor, e) : before, through ? mirrored(now, floor, e) : now};
}
