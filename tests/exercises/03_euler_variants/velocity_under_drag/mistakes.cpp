#include "exercise.hpp"

// Says: This is explicit Euler: the drag is taken at the old velocity.
// Hint: With the parachute open the old velocity is far too fast. Take the drag at v2, and solve for it.
namespace explicit_euler {

double velocity_under_drag(double v, double gravity, double k, double h) {
    return v + h * (-gravity - k * std::fabs(v) * v);
}

}  // namespace explicit_euler

// Says: Of the two velocities in |v| v, one is new and the other is old: a linear equation, not the one of
//       implicit Euler.
// Hint: It is stable and cheap, and often good enough in a game. Here both are to be new, which makes the
//       equation quadratic.
namespace half_implicit {

double velocity_under_drag(double v, double gravity, double k, double h) {
    return (v - h * gravity) / (1 + h * k * std::fabs(v));
}

}  // namespace half_implicit

// Says: Where there is no air, or no step, this divides zero by zero.
// Hint: Your root stands over 2 h k. Another way to write it has no such divisor.
namespace zero_over_zero {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity, q = h * k;
    const double size = (std::sqrt(1 + 4 * q * std::fabs(w)) - 1) / (2 * q);
    return w < 0 ? -size : size;
}

}  // namespace zero_over_zero

// Says: The root is right on paper, but digits are lost: by taking 1 from nearly 1 in thin air, or by float.
// Hint: Use double throughout. Then multiply above and below by the sum whose difference you form: nothing
//       cancels any more, and k = 0 needs no case of its own.
namespace digits_lost {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity, q = h * k;
    if (q == 0) return w;
    const double size = (std::sqrt(1 + 4 * q * std::fabs(w)) - 1) / (2 * q);
    return w < 0 ? -size : size;
}

}  // namespace digits_lost

// Says: The drag always points up, also for a body that rises: |v2| has been replaced by -v2.
// Hint: Which sign does v2 have? The velocity that gravity alone would give tells.
namespace falling_only {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return 2 * w / (1 + std::sqrt(std::fmax(0, 1 - 4 * h * k * w)));
}

}  // namespace falling_only

// Says: Gravity pulls upwards.
// Hint: Velocities point up, so gravity makes them smaller.
namespace gravity_up {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v + h * gravity;
    return 2 * w / (1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
}

}  // namespace gravity_up

// Says: This slows the body first, and adds gravity after that: the drag has not seen what gravity adds in
//       the step.
// Hint: The equation has one new velocity, and the drag depends on it. Put gravity to the right side before
//       you solve.
namespace gravity_afterwards {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double slowed = 2 * v / (1 + std::sqrt(1 + 4 * h * k * std::fabs(v)));
    return slowed - h * gravity;
}

}  // namespace gravity_afterwards

// Says: The drag is half of what it should be, as if it were k |v| v / 2.
// Hint: In the air the formula is often written with a half; here k has it inside already. Or look at the 4
//       under the root.
namespace half_drag {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return 2 * w / (1 + std::sqrt(1 + 2 * h * k * std::fabs(w)));
}

}  // namespace half_drag
