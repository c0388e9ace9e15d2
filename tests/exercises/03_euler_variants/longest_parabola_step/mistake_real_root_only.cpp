#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return zeta == 0 ? 0 : 1 / (zeta * omega);
}
