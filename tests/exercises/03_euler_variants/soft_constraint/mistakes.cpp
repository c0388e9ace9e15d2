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

// Says: gamma is multiplied by the mass, where it has to be divided: its unit is 1/kg.
// Hint: Heavy wheels need larger impulses for the same give. Does your gamma get smaller with the mass?
namespace times_mass {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double wh = omega * h;
    return {mass / (wh * (wh + 2 * zeta)), wh / (wh + 2 * zeta)};
}

}  // namespace times_mass

// Says: The 1 of the velocity is still in the divisor: these are the numbers of the step itself, before
//       they are compared with the solver's equation.
// Hint: In the solver's equation v2 stands with the factor 1, and J brings its own v1. Bring J = mass (v2 -
//       v1) in, and compare anew.
namespace not_normalised {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double wh = omega * h, divisor = 1 + 2 * zeta * wh + wh * wh;
    return {1 / (mass * divisor), wh * wh / divisor};
}

}  // namespace not_normalised

// Says: The damper is left out of both numbers: zeta is not used.
// Hint: The force has two terms. What becomes of c v2 when you collect the terms with v2?
namespace no_damper {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double wh = omega * h;
    return {1 / (mass * wh * wh), 1};
}

}  // namespace no_damper

// Says: The damper is 2 zeta omega: its mass is missing, while the stiffness has it.
// Hint: Both k and c come from an acceleration that is multiplied by the mass. Give it to both.
namespace damper_without_mass {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * zeta * omega;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}

}  // namespace damper_without_mass

// Says: The stiffness is mass times omega, where it has omega squared.
// Hint: The root of k over the mass is omega. Solve that for k.
namespace omega_not_squared {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega, c = 2 * mass * zeta * omega;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}

}  // namespace omega_not_squared

// Says: gamma stands upside down: this is h (c + h k), in kilograms.
// Hint: A stiff spring gives way little, so it must have a small gamma.
namespace gamma_upside_down {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {h * (c + h * k), h * k / (c + h * k)};
}

}  // namespace gamma_upside_down

// Says: The second number is the share of the damper, c / (c + h k), and not that of the spring.
// Hint: Without a damper the whole error is to be taken back. What is your beta for zeta = 0?
namespace damper_share {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {1 / (h * (c + h * k)), c / (c + h * k)};
}

}  // namespace damper_share

// Says: Without a damper your constraint is rigid: gamma is zero there.
// Hint: A spring without a damper still gives way. Put zeta = 0 into the formula for gamma.
namespace rigid_without_damper {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    if (zeta == 0) return {0.0, 1.0};
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega;
    return {1 / (h * (c + h * k)), h * k / (c + h * k)};
}

}  // namespace rigid_without_damper

// Says: gamma is right, but the 1 of the velocity is still in the divisor of beta: that is the share of one step of
//       implicit Euler.
// Hint: The solver divides by 1 + gamma m itself. Multiply by it before you read beta off.
namespace beta_not_normalised {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega, rate = c + h * k;
    return {1 / (h * rate), h * h * k / (mass + h * rate)};
}

}  // namespace beta_not_normalised

// Says: beta is right, but the 1 of the velocity is still in the divisor of gamma.
// Hint: What is left of the velocity in a step is gamma m / (1 + gamma m). Solve that for gamma.
namespace gamma_not_normalised {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega, rate = c + h * k;
    return {1 / (mass + h * rate), h * k / rate};
}

}  // namespace gamma_not_normalised

// Says: In gamma the damper brakes with the velocity at the beginning of the step. In implicit Euler it is the one at
//       the end.
// Hint: All of J, the damper's share, too, comes from v2. Where in your equation does v1 still stand?
namespace damper_at_the_old_velocity {

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    const double k = mass * omega * omega, c = 2 * mass * zeta * omega, rate = c + h * k;
    return {(1 - h * c / mass) / (h * rate), h * k / rate};
}

}  // namespace damper_at_the_old_velocity
