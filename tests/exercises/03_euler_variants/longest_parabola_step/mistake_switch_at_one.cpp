#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return (zeta < 1 ? 4 * zeta : 1 / zeta) / omega;
}
