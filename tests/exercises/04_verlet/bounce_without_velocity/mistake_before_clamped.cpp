#include "exercise.hpp"

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    return {std::max(floor, floor - e * (before - floor)), floor + e * (floor - now)};
}
