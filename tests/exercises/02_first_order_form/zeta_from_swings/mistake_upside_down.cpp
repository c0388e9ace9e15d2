#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(later / first) / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}
