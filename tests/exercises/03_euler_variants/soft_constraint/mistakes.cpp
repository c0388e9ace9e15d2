#include "exercise.hpp"

// Says: Both numbers are right, but beta comes first.
// Hint: The order is {gamma, beta}.
namespace swapped {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {h * k / (c + h * k), 1 / (h * (c + h * k))};
}

}  // namespace swapped

// Says: The damper is half as strong as zeta says: c has lost its factor two.
// Hint: Compare c v / mass with the acceleration in the task.
namespace half_damping {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = mass * zeta * omega;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}

}  // namespace half_damping

// Says: gamma is that of a body of one kilogram.
// Hint: J is a force times a time: stiffness and damping there are per body, not per kilogram.
namespace no_mass {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = omega * omega, c = 2 * zeta * omega;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}

}  // namespace no_mass

// Says: The spring pulls from the old position: this is the damper at the new velocity, as in semi-implicit
//       Euler, but the spring is not implicit.
// Hint: At the end of the step the wheel is at C + h v2.
namespace old_position {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {1 / (h * c), h * k / c};
}

}  // namespace old_position

// Says: The second number is beta / h, a rate, and not the share of the error in one step.
// Hint: In the solver's equation beta is already divided by h. Compare again, and look at the units.
namespace beta_over_h {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {1 / (h * (c + h * k)), k / (c + h * k)};
}

}  // namespace beta_over_h

// Says: gamma lacks a factor 1/h: it belongs to a force, not to an impulse.
// Hint: J is the force times h. Put that in before you compare.
namespace force_for_impulse {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {1 / (c + h * k), h * k / (c + h * k)};
}

}  // namespace force_for_impulse

// Says: omega has been taken for a frequency in hertz and multiplied by 2 pi.
// Hint: The task gives omega in rad/s. Use it as it is.
namespace hertz {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double w = 2 * std::numbers::pi * omega;
    const double k = mass * w * w, c = 2 * mass * zeta * w;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}

}  // namespace hertz

// Says: These are the numbers of the example, whatever the arguments.
// Hint: Put the spring's force at the end of the step into the solver's equation, with letters.
namespace example {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    return {1.0 / 6, 1.0 / 3};
}

}  // namespace example
