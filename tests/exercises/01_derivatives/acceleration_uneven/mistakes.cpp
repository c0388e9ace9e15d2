#include "exercise.hpp"

// Says: This is the formula for even frames, with the mean of the two intervals as its step.
// Hint: Try three positions of a body at constant velocity, with intervals 1 and 2: the middle position is
//       not the mean of the others, and still nothing accelerates.
namespace mean_step {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double h = (h0 + h1) / 2;
    return (x2 - 2 * x1 + x0) / (h * h);
}

}  // namespace mean_step

// Says: This is the formula for even frames, with the product of the two intervals in place of the square of
//       the step.
// Hint: The positions before and after need different weights, too. Begin with two velocities, each from its
//       own interval.
namespace product_of_steps {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return (x2 - 2 * x1 + x0) / (h0 * h1);
}

}  // namespace product_of_steps

// Says: The change of velocity is divided by the time from the first position to the last, so the
//       acceleration is half of what it should be.
// Hint: A chord's slope is the velocity in the middle of its interval. From the one middle to the other is
//       not the whole time.
namespace whole_time {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) / (h0 + h1);
}

}  // namespace whole_time

// Says: The change of velocity is divided by the newest interval alone. That is right only when both
//       intervals are equal.
// Hint: Mark on a line of time the two moments that your two velocities belong to, and measure the distance.
namespace newest_step {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) / h1;
}

}  // namespace newest_step

// Says: The older velocity minus the newer one: the acceleration has the wrong sign.
// Hint: A body that gets faster in the positive direction has a positive acceleration.
namespace older_minus_newer {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x1 - x0) / h0 - (x2 - x1) / h1) / (h0 + h1);
}

}  // namespace older_minus_newer

// Says: The two intervals are interchanged: each change of position is divided by the time of the other.
// Hint: h0 is the time from x0 to x1. Draw the three positions over time, and write each interval where it
//       belongs.
namespace intervals_swapped {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x2 - x1) / h0 - (x1 - x0) / h1) / (h0 + h1);
}

}  // namespace intervals_swapped

// Says: This is how much the velocity changes. Nothing has been divided by the time in which it does.
// Hint: The answer is in metres per second squared, and so far you have metres per second.
namespace change_of_velocity {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return (x2 - x1) / h1 - (x1 - x0) / h0;
}

}  // namespace change_of_velocity

// Says: The formula is right, but it is computed in float.
// Hint: A difference of nearly equal numbers, divided twice by a short time, needs every digit. Keep double
//       all the way.
namespace single_precision {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const float first = static_cast<float>(h0), second = static_cast<float>(h1);
    const float middle = static_cast<float>(x1);
    const float older = (middle - static_cast<float>(x0)) / first;
    const float newer = (static_cast<float>(x2) - middle) / second;
    return 2 * (newer - older) / (first + second);
}

}  // namespace single_precision
