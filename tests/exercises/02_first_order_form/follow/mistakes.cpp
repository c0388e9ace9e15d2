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
