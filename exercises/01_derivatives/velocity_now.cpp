// Chapter 1, exercise 1: the velocity now, from three frames
//
// Another player's position arrives every frame. You need the velocity at the newest frame, and
// the frame after it has not come yet. The backward difference $(x₂ − x₁)/h$ has order 1: use the
// third frame to reach order 2.
//
//   x0, x1, x2   positions at $t − 2h$, $t − h$ and $t$, in metres
//   h            time between two frames, in seconds (above zero)
//   returns      the velocity at $t$, the moment of $x₂$, in metres per second
//
// Example: for $x = t²$ at $t = 1$, 2, 3, `velocity_now(1, 4, 9, 1)` is 6, as the derivative $2t$
// says.
//
// What is checked: standing still gives zero; a constant velocity and a constant acceleration
// come out exactly, but for rounding, in games of any size and with any step; the error on any
// smooth motion falls as $h²$.

#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    return not_started;  // your answer
}
