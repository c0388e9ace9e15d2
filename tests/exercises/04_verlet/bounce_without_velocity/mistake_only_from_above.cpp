#include "exercise.hpp"

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    if (before > floor && now < floor)
        return {floor - e * (before - floor), floor + e * (floor - now)};
    return {before, now};
}
