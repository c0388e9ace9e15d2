#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / std::hypot(360, d);
}
