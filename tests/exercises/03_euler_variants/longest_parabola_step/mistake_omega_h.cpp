#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return zeta < 0.5 ? 4 * zeta : 1 / zeta;
}
