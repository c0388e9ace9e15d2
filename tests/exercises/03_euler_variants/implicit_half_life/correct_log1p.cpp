#include "exercise.hpp"

// (1 + ω²h²)^(n/2) = 2, and n h is asked.
double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return 2 * std::numbers::ln2 * h / std::log1p(wh * wh);
}
