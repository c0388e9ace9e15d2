#include "exercise.hpp"

// Says: This is explicit Euler: spring and damper pull at the old state, and the position moves with the old
//       velocity.
// Hint: It costs no division, and blows up in a long frame. Take the acceleration at x2 and v2, and solve.
namespace explicit_euler {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = v1 + wh * omega * (target - x1) - 2 * zeta * wh * v1;
    return {t1 + h, x1 + h * v1, v2};
}

}  // namespace explicit_euler

// Says: This is semi-implicit Euler: only the position uses something new.
// Hint: The new position belongs into the spring and the new velocity into the damper, too.
namespace semi_implicit {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = v1 + wh * omega * (target - x1) - 2 * zeta * wh * v1;
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace semi_implicit

// Says: The spring is taken at the new position, but the damper still pulls against the old velocity.
// Hint: There is one more term with v2: which divisor does it add to?
namespace old_damping {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1) - 2 * zeta * wh * v1) / (1 + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace old_damping

// Says: The damper is taken at the new velocity, but the spring still pulls from the old position: a long
//       frame can blow up.
// Hint: x2 is x1 + h v2. Put that into the spring, and it brings another term with v2.
namespace old_position {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace old_position

// Says: The new velocity is right, but the position has moved with the old one.
// Hint: Look at the second line of implicit Euler in the chapter's table.
namespace old_velocity_moves {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v1, v2};
}

}  // namespace old_velocity_moves

// Says: The spring pulls to x = 0, wherever the target is.
// Hint: The spring's force is zero where x is the target.
namespace no_target {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 - wh * omega * x1) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace no_target

// Says: The position that you return is counted from the target.
// Hint: It is a good idea to count from the target while you solve. At the end, go back to the world's
//       position.
namespace from_target {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 - target + h * v2, v2};
}

}  // namespace from_target

// Says: The damping is half of what zeta says: the factor two in 2 zeta omega v is missing.
// Hint: Take the acceleration letter by letter from the task.
namespace half_damping {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace half_damping

// Says: Position and velocity are right, but the state's time is still that of the old one.
// Hint: A state holds three numbers, and a step changes all three.
namespace clock_stands {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1, x1 + h * v2, v2};
}

}  // namespace clock_stands

// Says: The spring has the wrong sign: it pushes the camera away from the target, with x - target where
//       target - x must stand.
// Hint: Where the camera is left of its target, which sign must the spring's acceleration have?
namespace pushed_away {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (x1 - target)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace pushed_away

// Says: The divisor is right, but above it the spring's acceleration is added to a velocity: the step h is
//       missing there.
// Hint: An acceleration makes a velocity only in some time. Look at the units of the two terms above the
//       divisor.
namespace forgot_h {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + omega * omega * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace forgot_h

// Says: The terms with v2 have come to the left with the signs that they had on the right: the divisor is 1
//       minus something, and a long frame turns the camera round.
// Hint: A term that changes sides changes its sign. How large must the divisor be at least, so that no frame
//       can make the velocity grow?
namespace minus_in_divisor {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 - 2 * zeta * wh - wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace minus_in_divisor

// Says: Above the line the spring pulls with omega, where its acceleration has omega squared.
// Hint: An acceleration is metres per second squared. Where do the seconds come from in your spring?
namespace omega_not_squared {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace omega_not_squared

// Says: The damper is missing altogether: zeta is not used.
// Hint: The acceleration has two terms. Bring the second one to the left as well, and it adds to the
//       divisor.
namespace no_damper {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace no_damper

// Says: In the divisor the spring has h only once, where it belongs twice: once from the step, and once
//       from the position that has moved.
// Hint: Put x1 + h v2 into h omega² (target - x2), and count the letters h in front of v2.
namespace h_once_below {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * wh + wh * omega);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace h_once_below

// Says: The divisor lacks the 1 that the velocity itself brings: a short frame makes the camera race.
// Hint: On the left side of the equation stands v2 by itself, too. With h = 0 the divisor must be 1.
namespace one_forgotten {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double divisor = 2 * zeta * wh + wh * wh;
    const double v2 = divisor == 0 ? v1 : (v1 + wh * omega * (target - x1)) / divisor;
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace one_forgotten

// Says: The damper counts twice: it brakes the old velocity above the line, and stands in the divisor, too.
// Hint: Implicit Euler knows only the new velocity in the damper. Which of the two places is that of the
//       old one?
namespace damper_twice {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1) - 2 * zeta * wh * v1) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace damper_twice

// Says: The damper is 2 zeta v: its omega is missing, so that a stiff spring is hardly damped.
// Hint: Take both terms of the acceleration letter by letter from the task. What is the unit of 2 zeta v?
namespace damper_without_omega {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * h + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace damper_without_omega

// Says: The new velocity is right, but the position moves with the mean of the old one and the new one.
// Hint: That is better for a parabola, but it is another method. Which velocity does implicit Euler move
//       with?
namespace mean_of_velocities {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * (v1 + v2) / 2, v2};
}

}  // namespace mean_of_velocities

// Says: omega has been taken for oscillations in a second, and multiplied by 2 pi.
// Hint: An angular frequency has the 2 pi in it already. Use omega as the task gives it.
namespace hertz {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double w = 2 * std::numbers::pi * omega, wh = w * h;
    const double v2 = (v1 + wh * w * (target - x1)) / (1 + 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace hertz

// Says: In the divisor the damper has kept the minus that it had on the right: it drives the camera.
// Hint: A term that changes sides changes its sign, the damper's as well as the spring's.
namespace damper_minus_below {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1)) / (1 - 2 * zeta * wh + wh * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace damper_minus_below

// Says: The spring pulls from the place to which the old velocity would lead, and only the damper is solved for: h²
//       omega² is missing in the divisor.
// Hint: x2 is x1 + h v2, with the new velocity: that puts one more v2 on the left side.
namespace spring_from_old_velocity {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const auto& [t1, x1, v1] = state;
    const double wh = omega * h;
    const double v2 = (v1 + wh * omega * (target - x1 - h * v1)) / (1 + 2 * zeta * wh);
    return {t1 + h, x1 + h * v2, v2};
}

}  // namespace spring_from_old_velocity

// Says: Right, except in a step of zero: there something is divided by h, such as the way by the step, and that is
//       0/0.
// Hint: A frame of zero must change nothing. Solve for the velocity, and nothing is divided by h.
namespace way_over_step {

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const double wh = omega * h;
    const double x2 = (state.x * (1 + 2 * zeta * wh) + h * state.v + wh * wh * target) / (1 + 2 * zeta * wh + wh * wh);
    return {state.t + h, x2, (x2 - state.x) / h};
}

}  // namespace way_over_step
