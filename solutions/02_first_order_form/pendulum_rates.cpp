// Chapter 2, exercise 1: a lamp that swings, as a solver wants it
//
// A lamp hangs from the ceiling on a cable, and an explosion makes it swing. The angle $x$ is
// measured from hanging straight down, so the lamp runs along an arc with the speed
// $u = length v$. Along the arc it accelerates by $−g \sin x$, gravity, and by $−drag |u| u$, the
// air. Give your solver the first-order form in the unknowns $x$ and $v$. Swings may be large,
// and go over the top, and round and round.
//
//   s         the state now: time `s.t` in s, angle `s.x` in rad, angular velocity `s.v` in rad/s
//   g         acceleration of gravity, above zero, in m/s²
//   length    of the cable, above zero, in m
//   drag      of the air on the lamp, zero or more, in 1/m
//   returns   the rates of change of $x$, in rad/s, and of $v$, in rad/s², in this order
//
// Example: a quarter turn up, x = π/2, with $v = −1$, $g = 10$, $length = 2$ and $drag = 0.1$,
// the rates are −1 and −4.8.
//
// What is checked: a lamp at rest below or above the ceiling's hook stays there; the angle's rate;
// what gravity does to a lamp that is let go; what the air takes of the energy, for both directions
// of motion; left and right are alike; the time plays no part.

#include "exercise.hpp"

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    // [answer]
    const double u = length * s.v;
    const double along_the_arc = -g * std::sin(s.x) - drag * std::abs(u) * u;
    return {s.v, along_the_arc / length};
    // [answer]
}
