#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return std::max(4 * zeta, 1 / zeta) / omega;
}
