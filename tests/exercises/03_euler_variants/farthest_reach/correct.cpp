#include "exercise.hpp"

namespace cosine {

// The positions are samples of A cos(n theta + phi) with cos theta = 1 - omega² h² / 2, and two
// of them in a row tell A.
double farthest_reach(double x, double v, double omega, double h) {
    const double theta = 2 * std::asin(omega * h / 2);
    const double before = x - h * v;
    const double quadrature = (x * std::cos(theta) - before) / std::sin(theta);
    return std::hypot(x, quadrature);
}

}  // namespace cosine

namespace square {

// The modified energy as a sum of two squares: one of x alone, and one that is zero at the farthest x.
double farthest_reach(double x, double v, double omega, double h) {
    const double rest = v - h * omega * omega * x / 2;
    const double stiffness = omega * omega * (1 - h * h * omega * omega / 4);
    return std::sqrt(x * x + rest * rest / stiffness);
}

}  // namespace square
