#include "exercise.hpp"

// Says: This is the backward difference of the last two frames: the velocity of half a step ago. If there is a
//       correction, is it zero by a 1 / 2? In C++ that is 0: write 0.5.
// Hint: It has order one. The frame before holds what is missing: how fast the slope itself changes.
namespace two_frames {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x1) / h;
}

}  // namespace two_frames

// Says: This is the central difference: the velocity at the middle frame, one step ago. So is the mean of the two
//       slopes, and the newer slope with its correction subtracted.
// Hint: Velocity is asked at the newest frame, the last argument of the three.
namespace middle {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x0) / (2 * h);
}

}  // namespace middle

// Says: The weights are right, but nothing divides by the step.
// Hint: Positions are metres and the answer is metres per second: something must bring in the seconds.
namespace forgot_h {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / 2;
}

}  // namespace forgot_h

// Says: This is the velocity at the oldest frame: the formula looks the wrong way.
// Hint: Running time backwards interchanges x0 and x2, and changes the sign of a velocity, too. Or do you go on
//       from the older slope, where the newer one lies next to now?
namespace oldest_frame {

double velocity_now(double x0, double x1, double x2, double h) {
    return (-3 * x0 + 4 * x1 - x2) / (2 * h);
}

}  // namespace oldest_frame

// Says: The newer slope is corrected by the whole change between the two slopes, which is the velocity half
//       a step ahead.
// Hint: The two slopes belong to moments one step apart, but from the newer one to now is only half a step.
namespace half_too_much {

double velocity_now(double x0, double x1, double x2, double h) {
    return (2 * x2 - 3 * x1 + x0) / h;
}

}  // namespace half_too_much

// Says: The weights are right, but the result is multiplied by the step: / 2 * h, for one, divides by two and then
//       multiplies.
// Hint: C++ reads / and * from left to right. Put brackets round what is to stand below the line.
namespace missing_brackets {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / 2 * h;
}

}  // namespace missing_brackets

// Says: On paper it is right, but 3/2 is 1 and 1/2 is 0 in C++, where whole numbers divide into whole
//       numbers.
// Hint: Write 1.5 and 0.5. Or divide by two at the end, when a double stands above the line.
namespace whole_numbers {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 / 2 * x2 - 2 * x1 + 1 / 2 * x0) / h;
}

}  // namespace whole_numbers

// Says: The weights 3, 4 and 1 stand over h, where 2 h belongs: the velocity is twice what it should be.
// Hint: Let a body move at one metre per second, with frames one second apart. Which number do your weights
//       make of it?
namespace one_h_below {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 + x0) / h;
}

}  // namespace one_h_below

// Says: This is the velocity between the two oldest frames, one and a half steps ago.
// Hint: The newest position must have a say in the velocity of now. Which slope lies nearest to it?
namespace oldest_two {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x1 - x0) / h;
}

}  // namespace oldest_two

// Says: Oldest and newest frame are interchanged in the formula for now: it gives the velocity at the
//       oldest one, with the wrong sign.
// Hint: The largest weight belongs to the frame at whose moment the velocity is asked. Which argument is
//       that?
namespace swapped {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x0 - 4 * x1 + x2) / (2 * h);
}

}  // namespace swapped

// Says: The oldest position has the wrong sign: the weights no longer add up to zero, so a body far away
//       seems to race even when it rests.
// Hint: Put the same number into all three positions. The sum must vanish, and then the weights tell which
//       sign is wrong.
namespace oldest_subtracted {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 4 * x1 - x0) / (2 * h);
}

}  // namespace oldest_subtracted

// Says: This is the acceleration of the three frames, in metres per second squared.
// Hint: How fast the slope changes is what corrects the newer slope. It is not the velocity itself.
namespace acceleration {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - 2 * x1 + x0) / (h * h);
}

}  // namespace acceleration

// Says: This is twice the velocity of the middle frame: the way of two frames divided by the time of one, or the
//       sum of the two slopes.
// Hint: At a constant velocity of one metre per second, what comes out? And even half of it belongs to the middle
//       frame, not to now.
namespace two_steps_as_one {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x0) / h;
}

}  // namespace two_steps_as_one

// Says: Three frames are taken for three steps: the way from the first to the last is divided by 3 h.
// Hint: Three posts have two gaps between them. And that slope belongs to the moment in the middle, not to
//       now.
namespace three_steps {

double velocity_now(double x0, double x1, double x2, double h) {
    return (x2 - x0) / (3 * h);
}

}  // namespace three_steps

// Says: What is added to the newer slope is half of the acceleration, in metres per second squared. It has
//       not been multiplied by the time for which it acts.
// Hint: An acceleration changes a velocity only while time goes by. How much time lies between the middle
//       of the last step and now?
namespace correction_is_no_velocity {

double velocity_now(double x0, double x1, double x2, double h) {
    const double older = (x1 - x0) / h, newer = (x2 - x1) / h;
    return newer + (newer - older) / h / 2;
}

}  // namespace correction_is_no_velocity

// Says: The sign of all of it is turned round: a body that moves ahead gets a negative velocity.
// Hint: Subtract the older position from the newer one, and not the other way.
namespace against_time {

double velocity_now(double x0, double x1, double x2, double h) {
    return (4 * x1 - 3 * x2 - x0) / (2 * h);
}

}  // namespace against_time

// Says: Where the step is short you return zero, to be safe from a division. It is above zero, and that is enough.
// Hint: A short step comes with short ways, and their quotient is a velocity as any other.
namespace short_step_is_none {

double velocity_now(double x0, double x1, double x2, double h) {
    if (h < 1e-6) return 0;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

}  // namespace short_step_is_none

// Says: The middle position has the weight 3 where 4 belongs: the weights no longer add up to zero, so a body far away
//       seems to race even when it rests.
// Hint: Put the same number into all three positions. What must come out?
namespace middle_weighs_three {

double velocity_now(double x0, double x1, double x2, double h) {
    return (3 * x2 - 3 * x1 + x0) / (2 * h);
}

}  // namespace middle_weighs_three

// Says: What you add to the newer slope is in metres, no velocity yet: an h is missing below it. Is an
//       acceleration divided by h only once, or multiplied by h squared?
// Hint: Check the units of your correction. A change of velocity is an acceleration times a time.
namespace acceleration_over_h_once {

double velocity_now(double x0, double x1, double x2, double h) {
    const double a = (x2 - 2 * x1 + x0) / h;
    return (x2 - x1) / h + a * h / 2;
}

}  // namespace acceleration_over_h_once

// Says: The two backward slopes are mixed with 4/3 and −1/3. That is for errors that fall with h squared; those
//       of backward slopes fall with h.
// Hint: The slope over two steps has twice the error of that over one. How much of each makes the errors
//       cancel, and adds to one?
namespace central_weights {

double velocity_now(double x0, double x1, double x2, double h) {
    return (4 * (x2 - x1) / h - (x2 - x0) / (2 * h)) / 3;
}

}  // namespace central_weights

// Says: A mean of the two slopes, the newest with more weight, lies between them. The velocity now lies beyond
//       the newest one.
// Hint: The slopes belong to the middles of their intervals. Go on along the line through the two, to the end
//       of the last.
namespace weighted_mean {

double velocity_now(double x0, double x1, double x2, double h) {
    return ((x1 - x0) + 2 * (x2 - x1)) / (3 * h);
}

}  // namespace weighted_mean

// Says: Positions that nearly agree, beside their distance from the origin, are taken for those of a body at rest.
// Hint: A slow body far from the origin moves, too. You need no comparison: the differences of the positions tell its velocity.
namespace far_away_at_rest {

double velocity_now(double x0, double x1, double x2, double h) {
    if (std::fabs(x2 - x1) < 1e-6 * std::fabs(x2)) return 0;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}

}  // namespace far_away_at_rest
