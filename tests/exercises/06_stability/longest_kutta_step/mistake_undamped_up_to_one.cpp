#include "exercise.hpp"

double longest_kutta_step(double omega, double zeta) {
    if (zeta <= 1) return std::sqrt(3.0) / omega;
    double z = -2.5;  // where R(z) = -1
    for (int i = 0; i < 20; ++i) z -= (2 + z + z * z / 2 + z * z * z / 6) / (1 + z + z * z / 2);
    return -z / (omega * (zeta + std::sqrt(zeta * zeta - 1)));
}
