#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return 2 * (std::sqrt(1 + zeta * zeta) - zeta) / omega;
}
