#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later);
    return d / std::hypot(2 * std::numbers::pi, d) / swings;
}
