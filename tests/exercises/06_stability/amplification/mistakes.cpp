#include "exercise.hpp"

// Says: The slider works the other way round: at 0 this is implicit Euler.
// Hint: Which of the two rates stands beside theta in the task, that at y1 or that at y2?
namespace slider_reversed {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + theta * z) / (1.0 - (1 - theta) * z));
}

}  // namespace slider_reversed

// Says: This is the square of the size: std::norm, or the sum of the squares of both parts without its root.
// Hint: How large is 3 + 4i? std::abs is the function for the size.
namespace squared {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::norm((1.0 + (1 - theta) * z) / (1.0 - theta * z));
}

}  // namespace squared

// Says: R is right, but only its real part is returned.
// Hint: A factor i turns a motion and leaves it as large as it was; its real part is zero. The size has both
//       parts in it.
namespace real_part {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::fabs(((1.0 + (1 - theta) * z) / (1.0 - theta * z)).real());
}

}  // namespace real_part

// Says: R is right, but only its real part is returned, with its sign. A size is never negative.
// Hint: How long is the arrow from 0 to R? Its imaginary part belongs to it.
namespace signed_real_part {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return ((1.0 + (1 - theta) * z) / (1.0 - theta * z)).real();
}

}  // namespace signed_real_part

// Says: h is not used: this is the factor of a step of one second.
// Hint: R depends on z = h lambda.
namespace no_time {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> lambda(re, im);
    return std::abs((1.0 + (1 - theta) * lambda) / (1.0 - theta * lambda));
}

}  // namespace no_time

// Says: The divisor has the wrong sign: the rate at y2 has been put on the other side without changing it.
// Hint: y2 = y1 + ... + theta z y2. Take the last term to the left.
namespace divisor_plus {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + (1 - theta) * z) / (1.0 + theta * z));
}

}  // namespace divisor_plus

// Says: You have multiplied by the implicit part. It is a divisor.
// Hint: y2 (1 - theta z) = y1 (1 + (1 - theta) z). What is y2 / y1?
namespace multiplied {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + (1 - theta) * z) * (1.0 - theta * z));
}

}  // namespace multiplied

// Says: This mixes the factors of the two Eulers. The method mixes the rates, within one step.
// Hint: Put f(y) = lambda y into the equation of the task, and solve that for y2.
namespace mean_of_eulers {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return (1 - theta) * std::abs(1.0 + z) + theta / std::abs(1.0 - z);
}

}  // namespace mean_of_eulers

// Says: This does a step with each of the two Eulers, and mixes what they give. The method takes both rates
//       in one step, with its own y2.
// Hint: The rate that theta stands beside is taken at the y2 of this method, which is not the y2 of implicit
//       Euler.
namespace mean_of_factors {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1 - theta) * (1.0 + z) + theta / (1.0 - z));
}

}  // namespace mean_of_factors

// Says: The size is taken before adding. Complex numbers add like arrows: their sizes do not add.
// Hint: Compute R as a complex number. Take the size at the end.
namespace sizes_first {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return (1 + (1 - theta) * std::abs(z)) / (1 + theta * std::abs(z));
}

}  // namespace sizes_first

// Says: You have put |lambda| in for lambda: as if every motion grew at that rate, without swinging.
// Hint: The direction of lambda decides between growth and decay. Keep both re and im in z, and take a size
//       only of R.
namespace size_of_lambda {

double amplification(double re, double im, double theta, double h) {
    const double z = h * std::hypot(re, im);
    return std::fabs((1 + (1 - theta) * z) / (1 - theta * z));
}

}  // namespace size_of_lambda

// Says: You have put -|lambda| in for lambda: as if every motion were a pure decay.
// Hint: An oscillation, im without re, does not decay by itself. Let z be complex, and take the size of R alone.
namespace size_as_decay {

double amplification(double re, double im, double theta, double h) {
    const double z = -h * std::hypot(re, im);
    return std::fabs((1 + (1 - theta) * z) / (1 - theta * z));
}

}  // namespace size_as_decay

// Says: The imaginary part has been left out: this motion does not swing.
// Hint: im says how fast it swings, and explicit Euler makes an oscillation grow. Use a complex z.
namespace damping_only {

double amplification(double re, double im, double theta, double h) {
    const double z = h * re;
    return std::fabs((1 + (1 - theta) * z) / (1 - theta * z));
}

}  // namespace damping_only

// Says: This is what the true motion multiplies by, |e^z|. It knows no theta.
// Hint: A step of the method does something else. Solve its equation for y2, with f(y) = lambda y.
namespace true_motion {

double amplification(double re, double im, double theta, double h) {
    return std::exp(h * re);
}

}  // namespace true_motion

// Says: The slider stays half way: this is implicit midpoint for every theta.
// Hint: The chapter's R is one of a family. Where do its two halves come from?
namespace half_way_only {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + z / 2.0) / (1.0 - z / 2.0));
}

}  // namespace half_way_only

// Says: Right to a few digits only: numbers have gone through float, or another formula stands in for R
//       where z is small or large.
// Hint: Use std::complex<double>, no number with an f at its end, and the one R(z) for all z.
namespace single_precision {

double amplification(double re, double im, double theta, double h) {
    const std::complex<float> z(static_cast<float>(h * re), static_cast<float>(h * im));
    const float t = static_cast<float>(theta);
    return std::abs((1.0f + (1 - t) * z) / (1.0f - t * z));
}

}  // namespace single_precision

// Says: The rate at y2 is taken at a guess, that of an explicit Euler step. Here y2 is an unknown in an
//       equation, which is to be solved.
// Hint: Leave y2 on both sides. Bring all its terms to one side, and divide.
namespace predictor {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs(1.0 + (1 - theta) * z + theta * z * (1.0 + z));
}

}  // namespace predictor

// Says: The divisor has lost its h: it has theta lambda where theta h lambda belongs.
// Hint: h stands before both rates. Put z for h lambda before you solve.
namespace divisor_without_h {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> lambda(re, im);
    return std::abs((1.0 + (1 - theta) * h * lambda) / (1.0 - theta * lambda));
}

}  // namespace divisor_without_h

// Says: Above the line h is missing: it has (1 - theta) lambda where that times h belongs.
// Hint: What does a step of zero multiply by? Yours depends on lambda.
namespace numerator_without_h {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> lambda(re, im);
    return std::abs((1.0 + (1 - theta) * lambda) / (1.0 - theta * h * lambda));
}

}  // namespace numerator_without_h

// Says: theta stands above the line and below it. The rate at y1 has the other weight.
// Hint: At theta = 1 nothing of the old rate is left. What stands above the line then?
namespace theta_in_both {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + theta * z) / (1.0 - theta * z));
}

}  // namespace theta_in_both

// Says: The rate at y1 counts in full, whatever the slider says, and that at y2 comes on top.
// Hint: The two weights add up to one. What is that of f(y1)?
namespace whole_old_rate {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + z) / (1.0 - theta * z));
}

}  // namespace whole_old_rate

// Says: Every motion gets the factor of the example.
// Hint: Put f(y) = lambda y into the method, with letters.
namespace example {

double amplification(double re, double im, double theta, double h) {
    return 1.0288;
}

}  // namespace example

// Says: Below the line only the real part of z is left: a swing has lost its divisor.
// Hint: z is h (re + i im) above the line and below it. What is |1 - theta z| of a z that is purely imaginary?
namespace real_divisor {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im);
    return std::abs(1.0 + (1 - theta) * z) / std::fabs(1 - theta * h * re);
}

}  // namespace real_divisor

// Says: Where theta is nearly one half, an oscillation without damping is taken for one that keeps its size.
// Hint: Only at one half itself it keeps it. The formula knows that; no question is needed.
namespace nearly_half_way {

double amplification(double re, double im, double theta, double h) {
    if (re == 0 && std::fabs(theta - 0.5) < 1e-6) return 1;
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + (1 - theta) * z) / (1.0 - theta * z));
}

}  // namespace nearly_half_way

// Says: Only the rate at y1 is in it: the divisor, which is what the rate at y2 does, is missing.
// Hint: y2 stands on both sides of the equation. Bring it to one, and see what stands before it.
namespace divisor_left_out {

double amplification(double re, double im, double theta, double h) {
    return std::abs(1.0 + (1 - theta) * h * std::complex<double>(re, im));
}

}  // namespace divisor_left_out

// Says: In the size of a complex number the square of the imaginary part is taken off, where it should be
//       added.
// Hint: The size is the length of an arrow with two legs. What does Pythagoras say?
namespace squares_subtracted {

double amplification(double re, double im, double theta, double h) {
    const std::complex<double> z(h * re, h * im), above = 1.0 + (1 - theta) * z, below = 1.0 - theta * z;
    return std::sqrt(std::fabs((above * above).real() / (below * below).real()));
}

}  // namespace squares_subtracted
