#include "exercise.hpp"

double longest_kutta_step(double omega, double zeta) {
    return (zeta <= 1 ? 2 * zeta : 2 / (zeta + std::sqrt(zeta * zeta - 1))) / omega;
}
