#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return (std::sqrt(4 * zeta * zeta + 8) - 2 * zeta) / omega;
}
