#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return 1 / (zeta * omega);
}
