#include "exercise.hpp"

namespace two_steps {

// From two steps of implicit Euler. One starts on the spot at speed 1 and ends at v2 = 1 + J/mass,
// so v2 + gamma J = 0 gives gamma. The other starts at rest and gives beta.
std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double spring = h * omega * omega, damper = 2 * zeta * omega;
    const double divisor = 1 + h * (spring + damper);
    const double braked = -h * (spring + damper) / divisor;  // J/mass of the first
    const double pulled = -spring / divisor;                 // J/mass of the second, for C = 1
    const double gamma = -1 / (divisor * mass * braked);
    const double beta = -h * pulled * (1 + mass * gamma);
    return {gamma, beta};
}

}  // namespace two_steps

namespace units {

// Without units: only omega h and zeta are left, and the mass gives gamma its own.
std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double wh = omega * h, sum = 2 * zeta + wh;
    return {1 / (wh * sum * mass), wh / sum};
}

}  // namespace units

namespace one_division {

// By the divisor of the step, from which 1 is taken again: in short steps some digits go with it.
std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double divisor = 1 + 2 * zeta * omega * h + omega * omega * h * h;
    return {1 / (mass * (divisor - 1)), omega * omega * h * h / (divisor - 1)};
}

}  // namespace one_division

namespace by_the_share_that_is_left {

// What a step leaves of the velocity is share = gamma m / (1 + gamma m). In long steps little is left, and 1 is taken
// from much.
std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double divisor = 1 + h * omega * (2 * zeta + h * omega), share = 1 - 1 / divisor;
    return {(1 / share - 1) / mass, omega * omega * h * h / (divisor * share)};
}

}  // namespace by_the_share_that_is_left
