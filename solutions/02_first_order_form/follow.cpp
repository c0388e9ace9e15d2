// Chapter 2, exercise 4: a camera that follows, at any frame rate
//
// A camera hangs on its player by a spring and a damper, critically damped. Both are measured
// from the player: with $x$ and $v$ those of the camera less those of the player, the
// acceleration is $−ω² x − 2 ω v$. During one frame the player moves on with a constant velocity.
// Return the exact state of the camera a time $h$ later, for frames of any length: not a step of
// a solver, but the solution.
//
//   s         the camera now: time in s, position in m, velocity in m/s, seen from the ground
//   goal      position of the player now, in m, seen from the ground
//   goal_v    velocity of the player, constant, in m/s, seen from the ground
//   omega     angular frequency of the spring, above zero, in rad/s
//   h         time to go on, zero or more, in s
//   returns   state of the camera after $h$, its time, position and velocity, seen from the
//             ground
//
// Example: from rest at 0 at the time 0, with a player who rests at 1, $ω = 2$ and $h = 0.5$, the
// camera reaches $x = 0.264241$ with $v = 0.735759$, at the time 0.5.
//
// What is checked: a time of zero changes nothing; a camera on the player stays on the player; two
// steps land where one of the same length in all does; the velocity is the rate of the position;
// the equation of motion holds; from rest the camera never overshoots; frames that are millions of
// swings long; all of it for a player who moves.

#include "exercise.hpp"

State<double> follow(const State<double>& s, double goal, double goal_v, double omega, double h) {
    // [answer]
    const double x = s.x - goal, v = s.v - goal_v;
    const double b = v + omega * x;
    const double decay = std::exp(-omega * h);
    return {s.t + h, goal + goal_v * h + (x + b * h) * decay, goal_v + (v - omega * b * h) * decay};
    // [answer]
}
