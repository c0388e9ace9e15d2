// Chapter 7, exercise 6: a step that meets the ground
//
// In your game a ball flies under gravity, bounces on the ground at height 0, and lies still at
// last. A step that sees the ground only at its end spoils the order of every method. Yours meets
// it at the very moment: it bounces there, and goes on for the rest of the step, in which there may
// be more bounces. Then steps of any length are exact.
//
//   s         the state: `s.t` in seconds, the height `s.x` in metres (0 to 2000, on the ground
//             or above it), the velocity `s.v` in metres per second, above zero if upwards (-100
//             to 100)
//   g         gravity, which pulls down, in metres per second squared (1 to 25)
//   e         restitution: speed after a bounce over the speed before it (0 to 0.95, or 1)
//   h         the step, in seconds (above 0, up to 1e5)
//   returns   the state after the step, at `s.t + h`
//
// There is no air. A ball on the ground that moves down bounces at once. One that lies on the
// ground, with velocity 0, stays there. With $e$ below 1 each bounce is shorter than the one
// before, and all of them together, though there is no end of them, take a finite time: after it
// the ball lies still. Then, and for bounces slower than 1e-6 m/s, you may be off by 1e-6 m and
// 1e-6 m/s. With $e = 1$ there are at most 1000 bounces in a step. No step ends at the moment of
// a bounce.
//
// Example: `land_and_bounce({0, 5, 0}, 10, 0.5, 1.5)` is `{1.5, 1.25, 0}`. The ball falls for 1
// s, lands with 10 m/s and rises with 5 m/s; half a second later it has come to the top.
//
// What is checked: balls that do not land; balls that lie on the ground; the height to which a ball
// comes back, and its energy after one bounce and after many; where and when it comes to rest;
// restitutions 0 and 1; balls that start on the ground; one step is as good as two, and as good as
// many at any frame rate.

#include "exercise.hpp"

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    // [answer]
    const double end = s.t + h;
    double left = h;
    for (;;) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);  // the speed it lands with
        const double fall = (s.v + impact) / g;                    // s until it lands
        if (fall > left) return {end, s.x + s.v * left - g * left * left / 2, s.v - g * left};
        left -= fall;
        s.x = 0;
        s.v = e * impact;
        // All bounces to come take 2 v/g (1 + e + e^2 + ...).
        if (2 * s.v / g <= (1 - e) * left) return {end, 0, 0};
    }
    // [answer]
}
