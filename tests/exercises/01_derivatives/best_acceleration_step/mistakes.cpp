#include "exercise.hpp"

// Says: This is the optimal step size of the central difference for a velocity, with the snap in place of the jerk.
// Hint: Look at the unit: noise over snap is a time to the fourth power. Which root of it is a time?
namespace velocity {

double best_acceleration_step(double noise, double snap) {
    return std::cbrt(3 * noise / snap);
}

}  // namespace velocity

// Says: The noise is divided by the step only once, as in the formula of the chapter, which is for
//       velocities.
// Hint: Each position is divided by h squared here, and its noise with it. Write the sum down anew, and take
//       its slope.
namespace noise_over_h {

double best_acceleration_step(double noise, double snap) {
    return std::cbrt(24 * noise / snap);
}

}  // namespace noise_over_h

// Says: The root is the right one, but under it stands half of what belongs there: the noise is counted twice
//       where it must be four times, or the order of the formula is left in, as in the chapter, where the noise is
//       divided by h.
// Hint: At the worst, how far off together are three positions with the weights 1, −2 and 1? And take the slope
//       of both parts anew: each falls or rises with a square, so each brings a factor of two.
namespace chapters_factor {

double best_acceleration_step(double noise, double snap) {
    return std::pow(24 * noise / snap, 1.0 / 4);
}

}  // namespace chapters_factor

// Says: The noise of the middle position is counted once, so the worst noise is taken to be three times that
//       of one position.
// Hint: The middle position enters with the weight −2. At the worst it is off to one side and the others are
//       off to the other.
namespace middle_once {

double best_acceleration_step(double noise, double snap) {
    return std::pow(36 * noise / snap, 1.0 / 4);
}

}  // namespace middle_once

// Says: The root is the right one, but under it stands twice what belongs there: is the error term that of one
//       series, a 24th of the snap, or has one of the two parts lost its factor two in the slope?
// Hint: Both series hold the fourth power, and they are added: what stands before the snap then? And take the
//       slope of each part anew.
namespace one_series {

double best_acceleration_step(double noise, double snap) {
    return std::pow(96 * noise / snap, 1.0 / 4);
}

}  // namespace one_series

// Says: The truncation error is taken as the snap times the step squared, without the constant of the
//       series.
// Hint: The fourth power of the step comes with a factorial in the series. Keep it while you add the two.
namespace no_constant {

double best_acceleration_step(double noise, double snap) {
    return std::pow(4 * noise / snap, 1.0 / 4);
}

}  // namespace no_constant

// Says: This is the square of the optimal step size: one square root is missing.
// Hint: Where the two parts of the error are equal, one side has h squared above and the other has it below.
//       Multiply, and count the powers.
namespace square {

double best_acceleration_step(double noise, double snap) {
    return std::sqrt(48 * noise / snap);
}

}  // namespace square

// Says: Noise and snap stand upside down: this step gets shorter with more noise.
// Hint: What does a longer step do to the noise? So what should more noise do to the step?
namespace upside_down {

double best_acceleration_step(double noise, double snap) {
    return std::pow(snap / (48 * noise), 1.0 / 4);
}

}  // namespace upside_down

// Says: The root is the right one, but under it stands a quarter of what belongs there: most likely the noise is
//       that of one position, where the weights 1, −2 and 1 must be added by their sizes.
// Hint: Each position may be off to its own side. Choose the three signs so that the sum of the noise is as
//       large as it can be.
namespace noise_cancels {

double best_acceleration_step(double noise, double snap) {
    return std::pow(12 * noise / snap, 1.0 / 4);
}

}  // namespace noise_cancels

// Says: Every step comes out as 1. Is there an exponent 1 / 4? In C++ that is 0, where whole numbers divide into
//       whole numbers. Or does a search never leave its first step?
// Hint: Write 1.0 / 4 or 0.25, or take the square root twice. If you search, print where each round has got to.
namespace whole_number_exponent {

double best_acceleration_step(double noise, double snap) {
    return std::pow(48 * noise / snap, 1 / 4);
}

}  // namespace whole_number_exponent

// Says: The sum under the root is right, but it is the third root that you take.
// Hint: Noise over snap is seconds to the fourth power. Only one root of it gives seconds.
namespace cube_root {

double best_acceleration_step(double noise, double snap) {
    return std::cbrt(48 * noise / snap);
}

}  // namespace cube_root

// Says: The three noises are added by their squares, as independent random errors are. The task asks for
//       the worst case.
// Hint: At the worst all of them conspire: add their sizes, with the weights 1, 2 and 1.
namespace noises_by_squares {

double best_acceleration_step(double noise, double snap) {
    return std::pow(12 * std::sqrt(6.0) * noise / snap, 0.25);
}

}  // namespace noises_by_squares

// Says: This is the fourth power of the step: the root is missing.
// Hint: Solve your last equation for h itself. How many times does h stand in it as a factor?
namespace no_root {

double best_acceleration_step(double noise, double snap) {
    return 48 * noise / snap;
}

}  // namespace no_root

// Says: Noise and snap are in the right places, but the numbers that come with them, 4 and 12, are left
//       out.
// Hint: The bound is a number times snap h squared plus another times noise over h squared. Write both
//       numbers down before you take the slope.
namespace no_constants {

double best_acceleration_step(double noise, double snap) {
    return std::pow(noise / snap, 0.25);
}

}  // namespace no_constants

// Says: The 12 stands on the wrong side: dividing by snap / 12 multiplies by 12.
// Hint: Set snap h²/12 equal to 4 noise/h², and bring everything but h to the right, one factor at a time.
namespace twelve_below {

double best_acceleration_step(double noise, double snap) {
    return std::pow(4 * noise / (12 * snap), 0.25);
}

}  // namespace twelve_below

// Says: The truncation is taken to grow with the fourth power of the step. The series has that power, but then
//       it is divided by h squared.
// Hint: Write out the formula, with its divisor, and put the series in. Which power of h is left before the
//       snap?
namespace not_over_h_squared {

double best_acceleration_step(double noise, double snap) {
    return std::pow(24 * noise / snap, 1.0 / 6);
}

}  // namespace not_over_h_squared
