// Chapter NEW_NUMBER, exercise NEW_PLACE: NEW_TITLE
//
// FILL IN: who needs this function and why; here it is a step of a body that nothing pushes.
//
//   x         its position, in metres
//   v         its velocity, in metres per second
//   h         the length of the step, in seconds
//   returns   its position after the step, in metres
//
// Example: NEW_NAME(1, 2, 0.5) is 2.
//
// What is checked: a body at rest stays where it is; any other goes its velocity times the step.

#include "exercise.hpp"

double NEW_NAME(double x, double v, double h) {
    // [answer]
    return x + h * v;
    // [answer]
}
