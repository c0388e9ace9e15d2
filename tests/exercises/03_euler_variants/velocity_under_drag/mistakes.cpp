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

// Says: Gravity is taken off as if it were a velocity: it has not been multiplied by the step.
// Hint: In half the time a body gets half as fast. Check the units of what you subtract.
namespace gravity_without_h {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - gravity;
    return 2 * w / (1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
}

}  // namespace gravity_without_h

// Says: This solves the equation with a straight line in place of the square, drawn at the old velocity:
//       one round of Newton-Raphson.
// Hint: A quadratic equation has a formula. Where the drag is strong, one round is far from its root.
namespace linearised {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double a = -gravity - k * std::fabs(v) * v;
    return v + h * a / (1 + 2 * h * k * std::fabs(v));
}

}  // namespace linearised

// Says: The root has not been divided by h k: what comes out has no unit.
// Hint: The formula of the quadratic equation divides by twice the factor of the square. Which factor is
//       that here?
namespace divisor_forgotten {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    const double size = (std::sqrt(1 + 4 * h * k * std::fabs(w)) - 1) / 2;
    return w < 0 ? -size : size;
}

}  // namespace divisor_forgotten

// Says: This is the other root of the quadratic equation, whose sign does not fit: a falling body would
//       rise.
// Hint: The velocity that gravity alone would give tells the sign of the answer. Which root has it?
namespace other_root {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    if (h * k == 0) return w;
    const double size = (-1 - std::sqrt(1 + 4 * h * k * std::fabs(w))) / (2 * h * k);
    return w < 0 ? -size : size;
}

}  // namespace other_root

// Says: The drag acts against the old velocity. Where the body turns round in the step, that is the wrong
//       way.
// Hint: The direction is that of the new velocity, and the velocity that gravity alone would give has it
//       already.
namespace old_direction {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    const double sign = v > 0 ? 1 : -1;
    return 2 * w / (1 + std::sqrt(std::fmax(0, 1 + 4 * h * k * sign * w)));
}

}  // namespace old_direction

// Says: Gravity is left out: only the air is at work.
// Hint: A body at rest must begin to fall. Take h times gravity off before you solve.
namespace no_gravity {

double velocity_under_drag(double v, double gravity, double k, double h) {
    return 2 * v / (1 + std::sqrt(1 + 4 * h * k * std::fabs(v)));
}

}  // namespace no_gravity

// Says: The drag is taken to grow with the speed and not with its square: a linear equation.
// Hint: The task has |v| v. Keep both factors, and the equation becomes quadratic.
namespace linear_drag {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return w / (1 + h * k);
}

}  // namespace linear_drag

// Says: Gravity is right, but the drag is taken at the speed that the body would have without it, and the
//       other factor is new: a linear equation.
// Hint: In |v2| v2 both are the same number, the one that you look for. Leave both unknown.
namespace speed_without_drag {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return w / (1 + h * k * std::fabs(w));
}

}  // namespace speed_without_drag

// Says: After gravity, the drag is taken at the velocity that the body then has: that is explicit, and
//       throws it back.
// Hint: The drag must be that of the velocity at the end, which the drag itself has made small.
namespace explicit_after_gravity {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return w - h * k * std::fabs(w) * w;
}

}  // namespace explicit_after_gravity

// Says: Under the root the step is missing: 4 k |w| still has a unit.
// Hint: What stands under the root is added to 1, so it has no unit. Which time is there to make it so?
namespace root_without_h {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return 2 * w / (1 + std::sqrt(1 + 4 * k * std::fabs(w)));
}

}  // namespace root_without_h

// Says: Under the root the 4 of the quadratic formula is missing: the drag comes out far too weak.
// Hint: b² - 4 a c has a four. Write a, b and c of your equation down first.
namespace four_missing {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return 2 * w / (1 + std::sqrt(1 + h * k * std::fabs(w)));
}

}  // namespace four_missing

// Says: The answer always points down, as if every body fell.
// Hint: A body that rises fast goes on rising for a while. The velocity that gravity alone would give has
//       the sign.
namespace always_down {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return -2 * std::fabs(w) / (1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
}

}  // namespace always_down

// Says: Under the root stands a minus: this drag pushes along with the motion.
// Hint: Bring the drag to the left side of the equation, and look at its sign there once more.
namespace drag_pushes {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return 2 * w / (1 + std::sqrt(std::fmax(0, 1 - 4 * h * k * std::fabs(w))));
}

}  // namespace drag_pushes

// Says: The size is right, but the sign is that of the old velocity: a body that turns round in the step goes on rising.
// Hint: The velocity that gravity alone would give has the sign of the new one.
namespace old_sign {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    const double size = 2 * std::fabs(w) / (1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
    return v > 0 ? size : -size;
}

}  // namespace old_sign

// Says: The drag acts against the old velocity. Where the body turns round in the step, that is the wrong way, and
//       nothing real may be left under the root.
// Hint: No root of a negative number comes up where the drag is against the new velocity. Which sign has that?
namespace old_direction_under_the_root {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    const double sign = v > 0 ? 1 : -1;
    return 2 * w / (1 + std::sqrt(1 + 4 * h * k * sign * w));
}

}  // namespace old_direction_under_the_root

// Says: The size is right, but the sign is that of the old velocity, and a body that was at rest rises.
// Hint: Gravity may turn the velocity round in the step, and at rest it decides alone. Ask for the sign once gravity has
//       been at work.
namespace old_sign_and_up_from_rest {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    const double size = 2 * std::fabs(w) / (1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
    return v >= 0 ? size : -size;
}

}  // namespace old_sign_and_up_from_rest

// Says: The sign is right, but the size is that of the other root, with a plus before the square root.
// Hint: Without air the new velocity is v - h g. Which of the two roots comes near it as k becomes small?
namespace other_root_with_the_right_sign {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity, q = h * k;
    if (q == 0) return w;
    return std::copysign((1 + std::sqrt(1 + 4 * q * std::fabs(w))) / (2 * q), w);
}

}  // namespace other_root_with_the_right_sign

// Says: You return the speed. One who falls has a velocity below zero.
// Hint: The drag asks for the size of the velocity; the answer has its sign, too.
namespace speed_for_velocity {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double free = std::fabs(v - h * gravity);
    return 2 * free / (1 + std::sqrt(1 + 4 * h * k * free));
}

}  // namespace speed_for_velocity

// Says: The quadratic is that of falling, whichever way the character flies: on the way up the drag pushes
//       instead of braking.
// Hint: Drag is against the velocity. Which sign has k v |v| for a v above zero, and for one below?
namespace drag_of_falling {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double free = v - gravity * h;
    return 2 * free / (1 + std::sqrt(1 - 4 * k * h * free));
}

}  // namespace drag_of_falling

// Says: Where there is no air, or the step is zero, you divide by zero. Elsewhere the answer is right.
// Hint: Put k = 0 into each of your divisors. The root can be written with a divisor that is never below 1.
namespace only_with_air {

double velocity_under_drag(double v, double gravity, double k, double h) {
    const double w = v - h * gravity;
    return 2 * w / (h * k == 0 ? 0 : 1 + std::sqrt(1 + 4 * h * k * std::fabs(w)));
}

}  // namespace only_with_air
