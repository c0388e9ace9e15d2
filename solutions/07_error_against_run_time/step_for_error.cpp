// Chapter 7, exercise 1: which step is good enough
//
// In your game a grenade flies through the wind. You ran its flight once with a step of $h$, and
// compared it with the truth: it landed some centimetres off. Perhaps that is too far. Perhaps
// nobody would see ten times as much, and the step is wasteful. Which step is just right? The
// error of a whole run is $C h^{order}$, with a $C$ that is the same for all steps. (Nearly so,
// when steps are short.)
//
//   error     what the run with the step $h$ was off by, in metres (1e-12 to 1e3)
//   h         the step of that run, in seconds (1e-6 to 10)
//   order     of the method, 1 to 4
//   wanted    what a run may be off by, in metres (1e-12 to 1e3); below, at or above the error
//   returns   the step, in seconds, whose run is off by just what is wanted
//
// Example: `step_for_error(0.16, 0.02, 2, 0.01)` is 0.005, since with order two a quarter of the
// step has a sixteenth of the error.
//
// What is checked: a run that is off by just what is wanted keeps its step; half the step, and
// twice; for an error of $C h^{order}$, what a run with the step returned is off by; by way of
// another error; other units; a fall against the wind, run with methods of each order.

#include "exercise.hpp"

double step_for_error(double error, double h, int order, double wanted) {
    // [answer]
    return h * std::pow(wanted / error, 1.0 / order);
    // [answer]
}
