#include "exercise.hpp"

double longest_kutta_step(double omega, double zeta) {
    const double fast = -zeta - std::sqrt(zeta * zeta - 1);
    double good = 0, bad = 3;
    for (int i = 0; i < 80; ++i) {
        const double wh = (good + bad) / 2, z = wh * fast;
        (std::fabs(1 + z + z * z / 2 + z * z * z / 6) > 1 ? bad : good) = wh;
    }
    return good / omega;
}
