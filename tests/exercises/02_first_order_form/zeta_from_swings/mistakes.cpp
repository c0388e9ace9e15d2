#include "exercise.hpp"

// Says: This is the rule for small damping, delta / (2 pi): it takes a damped oscillation to last as long as an
//       undamped one.
// Hint: A damped oscillation takes longer, by one over the root of 1 - zeta squared. The rule gives more than 1
//       where hardly anything is left.
namespace small_damping {

double zeta_from_swings(double first, double later, int swings) {
    return std::log(first / later) / swings / (2 * std::numbers::pi);
}

}  // namespace small_damping

// Says: The number of oscillations is not used: all the loss is put down to a single period.
// Hint: Each oscillation multiplies by the same factor. What does that mean for the logarithm?
namespace one_swing {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later);
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace one_swing

// Says: The ratio of the peaks is divided by the number of oscillations before the logarithm is taken.
// Hint: Factors multiply, logarithms add: only one of them may be shared out evenly.
namespace ratio_shared_out {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later / swings);
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace ratio_shared_out

// Says: The ratio comes out as if a full period were half a turn: pi stands where 2 pi belongs, or the logarithm
//       is doubled, as by the squares of the heights.
// Hint: From a peak to the next one on the same side the phase goes all the way round. And a video shows heights,
//       not energies.
namespace half_swings {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / std::hypot(std::numbers::pi, d);
}

}  // namespace half_swings

// Says: The logarithm is the one to base ten.
// Hint: The oscillation fades as a power of e: its logarithm is std::log.
namespace base_ten {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log10(first / later) / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace base_ten

// Says: An oscillation that shrinks gets a negative damping: are the two peaks swapped, or is there a minus too
//       many?
// Hint: Damping takes away from the oscillation: the first peak is the larger one. Which sign has the logarithm of
//       your fraction?
namespace upside_down {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(later / first) / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace upside_down

// Says: The logarithm has half of its weight: is it halved, as if the heights were energies, or is a full period
//       counted as two turns?
// Hint: Energies go with the square of the height; a video shows heights. And from one peak to the next on the
//       same side, how far does the phase go?
namespace energy {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings / 2;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace energy

// Says: The relative loss stands for the logarithm, which it resembles only when little is lost.
// Hint: An oscillation that loses half each time never reaches nothing. Which function counts equal factors as
//       equal shares?
namespace relative_loss {

double zeta_from_swings(double first, double later, int swings) {
    const double d = (first - later) / first / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace relative_loss

// Says: The equation is solved with the wrong sign under the root: the ratio comes out as if damping made
//       the oscillation shorter.
// Hint: Square delta root(1 - zeta squared) = 2 pi zeta and collect the terms with zeta on one side. One
//       sign changes on the way.
namespace wrong_solve {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings, turn = 2 * std::numbers::pi;
    return d / std::sqrt(turn * turn - d * d);
}

}  // namespace wrong_solve

// Says: The whole loss is put into the formula as if it were that of one period, and only the ratio that
//       comes out is divided by the number of periods. That is right for small damping only.
// Hint: The formula is for the logarithm of one period. What must be divided before it goes under the root?
namespace shared_out_last {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later);
    return d / std::hypot(2 * std::numbers::pi, d) / swings;
}

}  // namespace shared_out_last

// Says: A full period is counted as 360 degrees where the formula wants radians.
// Hint: The oscillation is the sine or cosine of an angle in radians. How many of them go all the way round?
namespace degrees {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / std::hypot(360, d);
}

}  // namespace degrees

// Says: The logarithm is multiplied by the number of periods, where it has to be divided.
// Hint: What ten periods have taken is ten times what one takes. The formula wants that of one.
namespace times_swings {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) * swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace times_swings

// Says: Below the line, 2 pi and the logarithm are simply added. They are the two short sides of a
//       triangle, and the long one is wanted.
// Hint: Square both, add, and take the root: std::hypot does it.
namespace sides_added {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / (2 * std::numbers::pi + d);
}

}  // namespace sides_added

// Says: Below the line the square root is missing: the logarithm is divided by a sum of squares.
// Hint: Large damping must come out near one. What does your formula make of a very large logarithm?
namespace root_forgotten {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / (4 * std::numbers::pi * std::numbers::pi + d * d);
}

}  // namespace root_forgotten

// Says: The number of periods is taken one too large, as if the peaks were counted and not what lies
//       between them.
// Hint: The argument counts the full periods already. Two peaks that follow each other are one of them
//       apart.
namespace peaks_counted {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / (swings + 1);
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace peaks_counted

// Says: Under the root stand 2 pi and the square of the logarithm: 2 pi has not been squared.
// Hint: Both sides of the triangle are squared, not only the one that you measured.
namespace turn_not_squared {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / std::sqrt(2 * std::numbers::pi + d * d);
}

}  // namespace turn_not_squared

// Says: A full period is taken for an angle of one: 2 pi is missing.
// Hint: How many radians does the oscillation run through from one peak to the next on the same side?
namespace turn_without_two_pi {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log(first / later) / swings;
    return d / std::hypot(1, d);
}

}  // namespace turn_without_two_pi

// Says: The ratio of the peaks itself stands in the place of its logarithm.
// Hint: Equal peaks must give no damping. Which function makes zero of one?
namespace no_logarithm {

double zeta_from_swings(double first, double later, int swings) {
    const double d = first / later / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace no_logarithm

// Says: The logarithm is the one to base two: it counts halvings.
// Hint: The oscillation fades as e to some power. Which logarithm belongs to that?
namespace binary_logarithm {

double zeta_from_swings(double first, double later, int swings) {
    const double d = std::log2(first / later) / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace binary_logarithm

// Says: What is lost is compared with the later peak, and stands for the logarithm, which it resembles only
//       for small losses.
// Hint: Two losses in a row must count as the sum of both. Which function of the ratio does that?
namespace relative_to_the_later {

double zeta_from_swings(double first, double later, int swings) {
    const double d = (first / later - 1) / swings;
    return d / std::hypot(2 * std::numbers::pi, d);
}

}  // namespace relative_to_the_later

// Says: The logarithm of each peak is taken by itself. Of heights below zero, on the other side, there is none.
// Hint: The ratio of the two peaks is above zero on either side.
namespace separate_logarithms {

double zeta_from_swings(double first, double later, int swings) {
    const double decrement = (std::log(first) - std::log(later)) / swings;
    return decrement / std::hypot(2 * std::numbers::pi, decrement);
}

}  // namespace separate_logarithms
