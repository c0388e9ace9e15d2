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

// Says: The acceleration is half of what it should be: is the change of velocity divided by the time from the
//       first position to the last, or has the half of a Taylor series stayed behind?
// Hint: Two velocities that each belong to the middle of their interval: from the one middle to the other is not
//       the whole time. Test it with the example, x = t².
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

// Says: The acceleration has the wrong sign: is the newer velocity taken off the older one, or does each of the
//       two count its way backwards in time?
// Hint: A body that gets faster in the positive direction has a positive acceleration.
namespace older_minus_newer {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x1 - x0) / h0 - (x2 - x1) / h1) / (h0 + h1);
}

}  // namespace older_minus_newer

// Says: The two intervals are interchanged: each change of position goes with the time of the other.
// Hint: Let a body move at a constant velocity, with intervals of 1 and 2. What does each of your two terms give,
//       and what must it give?
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

// Says: The newer of your velocities is measured over the whole time, from the first position to the last:
//       the two overlap.
// Hint: Each velocity belongs to the middle of its own interval. Take the newer one from the last two
//       positions alone.
namespace older_and_whole {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x2 - x0) / (h0 + h1) - (x1 - x0) / h0) / (h0 + h1);
}

}  // namespace older_and_whole

// Says: The change of velocity is multiplied by the time in which it happens, where it has to be divided.
// Hint: The same change in a shorter time is a larger acceleration. Check the unit of what you return.
namespace times_time {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) * (h0 + h1) / 2;
}

}  // namespace times_time

// Says: Both changes of position are divided by the first interval, so a constant velocity seems to change.
// Hint: The way from x1 to x2 has taken the time h1. Give each way its own time.
namespace first_interval_for_both {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x2 - x1) / h0 - (x1 - x0) / h0) / (h0 + h1);
}

}  // namespace first_interval_for_both

// Says: Both changes of position are divided by the second interval, also the one that took the first.
// Hint: The way from x0 to x1 has taken the time h0. With which of the two times do you divide it?
namespace second_interval_for_both {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return 2 * ((x2 - x1) / h1 - (x1 - x0) / h1) / (h0 + h1);
}

}  // namespace second_interval_for_both

// Says: This is the velocity at the middle position: the weighted mean of the two slopes, in metres per
//       second.
// Hint: Not the mean of the two velocities is asked but how fast the one becomes the other.
namespace velocity {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x1 - x0) / h0 * h1 + (x2 - x1) / h1 * h0) / (h0 + h1);
}

}  // namespace velocity

// Says: This is the formula for even frames, with the first interval as the step of both.
// Hint: A packet that comes late makes the second interval longer. Where does your formula see that?
namespace first_step_squared {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return (x2 - 2 * x1 + x0) / (h0 * h0);
}

}  // namespace first_step_squared

// Says: This is the formula for even frames, with the second interval taken for both of them.
// Hint: The first interval does not enter at all. Begin with two velocities, and give each of them its own
//       time.
namespace second_step_squared {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return (x2 - 2 * x1 + x0) / (h1 * h1);
}

}  // namespace second_step_squared

// Says: The change of velocity is divided by the first interval alone, whatever the second one is.
// Hint: The two velocities belong to the middles of the intervals. Half of each lies between them.
namespace oldest_step {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) / h0;
}

}  // namespace oldest_step

// Says: The change of velocity is divided by the sum of the intervals and then by two once more: a quarter
//       of the acceleration.
// Hint: Brackets matter: a sum that is to be halved below the line is one that doubles the whole.
namespace halved_twice {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) / (h0 + h1) / 2;
}

}  // namespace halved_twice

// Says: Only the second interval is halved: h0 + h1 / 2 is not the time between the two middles.
// Hint: C++ divides before it adds. Put brackets round the sum.
namespace missing_brackets {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    return ((x2 - x1) / h1 - (x1 - x0) / h0) / (h0 + h1 / 2);
}

}  // namespace missing_brackets

// Says: Where an interval is short you return zero, to be safe from a division. It is above zero, and that is enough.
// Hint: A short interval comes with a short way, and their quotient is a velocity as any other.
namespace short_interval_is_none {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    if (h0 < 1e-6 || h1 < 1e-6) return 0;
    return 2 * ((x2 - x1) / h1 - (x1 - x0) / h0) / (h0 + h1);
}

}  // namespace short_interval_is_none

// Says: The two Taylor series are added as for even frames. Then the velocity remains in the sum, times the
//       difference of the two steps, and a constant velocity has an acceleration.
// Hint: The term with the velocity is h1 v in one series and −h0 v in the other. With what must you multiply
//       the series before you add them?
namespace series_added {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double ahead = x2 - x1, back = x0 - x1;
    return 2 * (ahead + back) / (h0 * h0 + h1 * h1);
}

}  // namespace series_added

// Says: The slope of the whole chord, from the first position to the last, is taken for the velocity at the one
//       between. With uneven frames it belongs to the middle of the whole time, which is another moment.
// Hint: To which moment does each chord's slope belong? Mark both, and divide by what lies between.
namespace chord_for_the_middle {

double acceleration_uneven(double x0, double x1, double x2, double h0, double h1) {
    const double whole = (x2 - x0) / (h0 + h1), newest = (x2 - x1) / h1;
    return 2 * (newest - whole) / h1;
}

}  // namespace chord_for_the_middle
