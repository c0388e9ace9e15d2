#include "exercise.hpp"

// With w = omega h the trace is 2 - 2 zeta w - w²/2, the determinant 1 - 2 zeta w + w²/2. A pair
// of complex roots leaves where the determinant is 1, at w = 4 zeta, and a real one where
// 1 + trace + determinant = 4 - 4 zeta w is 0.
double longest_parabola_step(double omega, double zeta) {
    return (zeta < 0.5 ? 4 * zeta : 1 / zeta) / omega;
}
