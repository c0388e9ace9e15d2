// Chapter 3, exercise 1: how soon an oscillation fades that should not
//
// A shop sign hangs on a spring without a damper. You step it with implicit Euler, and after a
// while it hangs still: the method takes a share of the amplitude in every step. When is half of it
// gone?
//
//   omega    angular frequency of the spring, rad/s (above zero)
//   h        length of a step, s (above zero; $ω h$ from 10⁻⁶ to 1000)
//   returns  the time after which the amplitude is half of what it was, in seconds. It need not be
//            a whole number of steps: the amplitude falls by the same factor in each step, as an
//            exponential does, and you tell when that exponential is at one half.
//
// Where $ω h$ is tiny, $1 + ω² h²$ has lost most digits of $ω² h²$. The standard library has a
// function for that: std::log1p(u) is the logarithm of $1 + u$, with all its digits.
//
// Example: `implicit_half_life(2, 0.1)` is 3.5346 seconds, a bit more than 35 steps.
//
// What is checked: a stepped spring is at half its amplitude then; it comes out right where a
// single step takes half, or more; only $ω h$ decides how many steps it takes; for short steps,
// half the step means twice the time; long steps, and tiny ones, which lose no digits.

#include "exercise.hpp"

double implicit_half_life(double omega, double h) {
    return not_started;  // your answer
}
