#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return (zeta < 1 ? 2 * zeta : 2 / zeta) / omega;
}
