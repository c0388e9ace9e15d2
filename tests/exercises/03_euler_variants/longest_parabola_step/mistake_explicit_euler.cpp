#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    if (zeta <= 1) return 2 * zeta / omega;
    return 2 / (zeta + std::sqrt(zeta * zeta - 1)) / omega;
}
