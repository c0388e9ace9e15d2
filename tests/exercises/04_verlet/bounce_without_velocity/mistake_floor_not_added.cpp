#include "exercise.hpp"

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (now >= floor) return {before, now};
    const double risen = e * (floor - now);
    return {risen + e * (now - before), risen};
}
