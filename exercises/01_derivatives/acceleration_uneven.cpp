// Chapter 1, exercise 2: the acceleration, from frames at uneven times
//
// Positions come over a network, and one packet was late. So the two intervals between the last
// three positions are not equal. You need the acceleration at the middle position. With one step
// for both you would find an acceleration even where the velocity is constant.
//
//   x0, x1, x2   positions, oldest first, in metres
//   h0           time from $x₀$ to $x₁$, in seconds (above zero)
//   h1           time from $x₁$ to $x₂$, in seconds (above zero)
//   returns      the acceleration at the moment of $x₁$, in metres per second squared
//
// Example: for $x = t²$ at $t = 1$, 2 and 4, `acceleration_uneven(1, 4, 16, 1, 2)` is 2, as the
// second derivative says.
//
// What is checked: a constant velocity has no acceleration, and a constant acceleration comes out
// exactly, but for rounding, whatever the two intervals; run backwards, a motion has the same
// acceleration; the error on any smooth motion falls as the step, and as its square when the two
// intervals are equal.

#include "exercise.hpp"

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return not_started;  // your answer
}
