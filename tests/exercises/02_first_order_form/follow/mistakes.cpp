#include "exercise.hpp"

// Says: The player is taken to stand still: goal_v is not used.
// Hint: Let the camera ride on a moving player. Where must it be after the frame?
namespace target_stands_still {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + (x + b * h) * e, (v - omega * b * h) * e};
}

}  // namespace target_stands_still

// Says: The motion starts with the velocity of the camera as seen from the ground, while everything else is
//       seen from the player.
// Hint: Both the position and the velocity must be those that the player sees.
namespace velocity_from_the_ground {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace velocity_from_the_ground

// Says: The answer is the camera as the player sees it: it has not been brought back to the ground.
// Hint: What was subtracted at the start must be added at the end, for the position and for the velocity.
namespace not_back_to_the_ground {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, (x + b * h) * e, (v - omega * b * h) * e};
}

}  // namespace not_back_to_the_ground

// Says: The camera is brought back to where the player was when the frame began.
// Hint: The player has moved on during the frame.
namespace old_target {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace old_target

// Says: This is one step of explicit Euler, not the solution.
// Hint: A long frame throws the camera far off. The chapter has the exact motion at critical damping.
namespace explicit_euler {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double a = -omega * omega * x - 2 * omega * v;
    return {s.t + h, s.x + h * s.v, s.v + h * a};
}

}  // namespace explicit_euler

// Says: Position and velocity just fade by the exponential: this is a first-order decay, not a spring with a
//       damper.
// Hint: At critical damping the exponential is multiplied by a line in time. A camera at rest needs a while
//       to get going.
namespace fade_only {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + x * e, goal_v + v * e};
}

}  // namespace fade_only

// Says: The position is right, but the velocity is the mean one over the frame.
// Hint: The velocity at the end of the frame is the derivative of the position there. Differentiate the
//       formula.
namespace mean_velocity {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    if (h == 0) return s;
    const double x = s.x - goal, v = s.v - goal_v;
    const double moved = goal + goal_v * h + (x + (v + omega * x) * h) * std::exp(-omega * h);
    return {s.t + h, moved, (moved - s.x) / h};
}

}  // namespace mean_velocity

// Says: The velocity is the derivative of the exponential only: the line in front of it changes, too.
// Hint: A product has two factors, and each of them has its turn in the derivative.
namespace product_rule_forgotten {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double line = x + (v + omega * x) * h, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + line * e, goal_v - omega * line * e};
}

}  // namespace product_rule_forgotten

// Says: The line in front of the exponential starts with the slope v: the share omega x is missing, so the
//       motion starts with the wrong velocity.
// Hint: Differentiate your position at h = 0: is it the velocity at the start?
namespace start_ignores_position {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + v * h) * e, goal_v + (v - omega * (x + v * h)) * e};
}

}  // namespace start_ignores_position

// Says: The camera moves rightly, but its time stays behind.
// Hint: A state is a time, a position and a velocity: all three go on.
namespace clock_stands {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace clock_stands

// Says: The position is that on the ground, but the velocity is still the one that the player sees.
// Hint: You took the player's velocity away at the start. Where does it come back?
namespace velocity_not_back {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, (v - omega * b * h) * e};
}

}  // namespace velocity_not_back

// Says: The velocity is that on the ground, but the position is still counted from the player.
// Hint: What the camera shows depends on where it is in the world: add the place where the player has got
//       to.
namespace position_not_back {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace position_not_back

// Says: The slope of the line in front of the exponential is v - omega x, with the wrong sign.
// Hint: At h = 0 the exponential falls at the rate omega x. What must the line add to that, so that the
//       camera starts with v?
namespace constant_with_minus {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v - omega * x, line = x + b * h, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + line * e, goal_v + (b - omega * line) * e};
}

}  // namespace constant_with_minus

// Says: This is one step of implicit Euler: it is stable, but it is not the solution.
// Hint: Half the frame, twice, must lead to the same place. For a division alone it does not, and the
//       chapter has the exact motion.
namespace implicit_euler {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double wh = omega * h, after = (v - omega * wh * x) / (1 + 2 * wh + wh * wh);
    return {s.t + h, goal + goal_v * h + x + h * after, goal_v + after};
}

}  // namespace implicit_euler

// Says: This is one step of semi-implicit Euler. Long frames blow it up, and short ones have the wrong
//       motion, too.
// Hint: The task asks for the solution itself, which needs an exponential. Which one, at critical damping?
namespace semi_implicit_euler {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double after = v + h * (-omega * omega * x - 2 * omega * v);
    return {s.t + h, goal + goal_v * h + x + h * after, goal_v + after};
}

}  // namespace semi_implicit_euler

// Says: The position is right, but the velocity is that of the start, faded by the exponential: no spring
//       pulls at it.
// Hint: A camera at rest away from its player gets a velocity. Differentiate the whole position, by the
//       time.
namespace velocity_only_fades {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + v * e};
}

}  // namespace velocity_only_fades

// Says: The exponential falls with 2 omega: this is the motion of a spring that is twice as fast.
// Hint: The damper has the factor 2, and so has the sum of two equal roots. Each of the two roots is
//       -omega.
namespace omega_doubled {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double w = 2 * omega, b = v + w * x, e = std::exp(-w * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - w * b * h) * e};
}

}  // namespace omega_doubled

// Says: The distance fades by the exponential alone, and the velocity that the camera had is not used: a
//       smoothing of first order.
// Hint: A spring with a damper needs two numbers to start from. Which motion has the velocity v at the
//       beginning?
namespace exponential_lerp {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + x * e, goal_v - omega * x * e};
}

}  // namespace exponential_lerp

// Says: This is the spring without its damper: a sine and a cosine, which go on for ever.
// Hint: Critically damped there is no swinging left. Which functions take the place of sine and cosine?
namespace no_damper {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double c = std::cos(omega * h), sine = std::sin(omega * h);
    return {s.t + h, goal + goal_v * h + x * c + v / omega * sine, goal_v + v * c - omega * x * sine};
}

}  // namespace no_damper

// Says: The distance at the start is measured from where the player will be, not from where he is.
// Hint: Both the camera and the player have a place now. Take these two, and let him go on afterwards.
namespace measured_from_the_end {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - (goal + goal_v * h), v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace measured_from_the_end

// Says: The exponential has lost its minus: the distance grows instead of fading.
// Hint: After a long frame hardly anything of the distance may be left. Which sign must the exponent have?
namespace grows {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace grows

// Says: The position is right, but in the velocity the term of the fading line is added, where it is to be
//       subtracted.
// Hint: The derivative of the exponential brings a minus. Differentiate the product once more, one factor
//       at a time.
namespace sign_in_velocity {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v + omega * b * h) * e};
}

}  // namespace sign_in_velocity

// Says: The time that you return is the length of the frame, as if the clock began anew with it.
// Hint: The state has a time, too: s.t. What is the time after h more seconds?
namespace clock_begins_anew {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace clock_begins_anew

// Says: goal_v moves the player on, but the velocity of the camera is never that seen from him: goal_v is neither taken
//       off at the start nor added at the end.
// Hint: The spring pulls at x, and the damper at v, both less those of the player. Which of the two have you taken less
//       his?
namespace velocity_never_seen_from_the_player {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v;
    const double b = v + omega * x, e = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, (v - omega * b * h) * e};
}

}  // namespace velocity_never_seen_from_the_player

// Says: For the exponential stands the quick quotient that games often use, which is off by up to 0.02.
// Hint: Two frames must lead where one of their length does. Of which function are two halves multiplied the whole?
namespace quotient_for_exponential {

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    const double x = s.x - goal, v = s.v - goal_v, wh = omega * h;
    const double b = v + omega * x, e = 1 / (1 + wh * (1 + wh * (0.48 + 0.235 * wh)));
    return {s.t + h, goal + goal_v * h + (x + b * h) * e, goal_v + (v - omega * b * h) * e};
}

}  // namespace quotient_for_exponential
