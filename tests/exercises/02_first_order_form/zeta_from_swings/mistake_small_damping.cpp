#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    return std::log(first / later) / swings / (2 * std::numbers::pi);
}
