#include "exercise.hpp"

// Says: This is half of the time: 1/(1 + omega² h²), the determinant, is what a step does to an area and to the
//       energy, not to the amplitude.
// Hint: An area shrinks in two directions at once, and the energy goes with the square of the amplitude. What is
//       left for the amplitude itself?
namespace determinant {

double implicit_half_life(double omega, double h) {
    return std::log(2) * h / std::log(1 + omega * omega * h * h);
}

}  // namespace determinant

// Says: This is the time after which the amplitude is 1/e of what it was, the time constant.
// Hint: You are asked for a half. Is the logarithm of two in your formula, and to the same base as the other one?
namespace time_constant {

double implicit_half_life(double omega, double h) {
    return 2 * h / std::log(1 + omega * omega * h * h);
}

}  // namespace time_constant

// Says: This is a number of steps, but a time is asked.
// Hint: How many seconds do so many steps take?
namespace steps {

double implicit_half_life(double omega, double h) {
    return 2 * std::log(2) / std::log(1 + omega * omega * h * h);
}

}  // namespace steps

// Says: This is the approximation for short steps: it takes log(1 + u) for u.
// Hint: The approximation is good while omega h is small. Keep the logarithm.
namespace short_steps {

double implicit_half_life(double omega, double h) {
    return 2 * std::log(2) / (omega * omega * h);
}

}  // namespace short_steps

// Says: The time is negative: this is how long ago the amplitude was twice as large as now, counted
//       backwards.
// Hint: Both logarithms must have the same sign: a half goes with a factor below one.
namespace backwards {

double implicit_half_life(double omega, double h) {
    return std::log(0.5) * h / std::log(std::sqrt(1 + omega * omega * h * h));
}

}  // namespace backwards

// Says: This multiplies omega by 2 pi, as if it were a number of oscillations a second.
// Hint: omega is an angular frequency, in rad/s. The factor of the step takes it as it is.
namespace hertz {

double implicit_half_life(double omega, double h) {
    const double wh = 2 * std::numbers::pi * omega * h;
    return 2 * std::log(2) * h / std::log(1 + wh * wh);
}

}  // namespace hertz

// Says: Right on paper, but digits are lost where omega h is tiny: 1 + omega² h² is rounded before its
//       logarithm is taken.
// Hint: The root can wait: the logarithm of a square root is half the logarithm. Then std::log1p takes
//       omega² h² without the 1.
namespace digits_lost {

double implicit_half_life(double omega, double h) {
    const double shrinks = 1 / std::sqrt(1 + omega * omega * h * h);
    return std::log(0.5) / std::log(shrinks) * h;
}

}  // namespace digits_lost

// Says: This is the number of the example, whatever the arguments.
// Hint: Each spring and each step has its own: the answer depends on omega and h.
namespace example {

double implicit_half_life(double omega, double h) {
    return 3.5346;
}

}  // namespace example

// Says: This is rounded up to whole steps. The task asks when the exponential through all steps is at one
//       half, which may be between two of them, or within the first.
// Hint: A number of steps need not be a whole number. Leave it as the logarithms give it.
namespace whole_steps {

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return std::ceil(2 * std::log(2) / std::log1p(wh * wh)) * h;
}

}  // namespace whole_steps

// Says: Under the logarithm stands 1 + omega h: the square is missing.
// Hint: The size of 1 - i omega h is a hypotenuse, and its sides enter squared.
namespace not_squared {

double implicit_half_life(double omega, double h) {
    return 2 * std::log(2) * h / std::log1p(omega * h);
}

}  // namespace not_squared

// Says: The amplitude is divided by 1 + omega h in each step, which is so for a decay. In an oscillation it is the
//       root of 1 + omega² h², and a root of a sum is not the sum of the roots.
// Hint: The size of 1 - i omega h is asked: the long side of a triangle whose short sides are 1 and omega h.
namespace root_without_the_one {

double implicit_half_life(double omega, double h) {
    return std::log(2) * h / std::log1p(omega * h);
}

}  // namespace root_without_the_one

// Says: Above the line stands a natural logarithm, and below it one to base ten.
// Hint: Any base will do, as long as it is the same for both.
namespace decimal_logarithm {

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return 2 * std::log(2) * h / std::log10(1 + wh * wh);
}

}  // namespace decimal_logarithm

// Says: std::log1p is given 1 + omega² h², but it adds the 1 itself: this is the logarithm of 2 + omega²
//       h².
// Hint: log1p(u) is the logarithm of 1 + u. What is u here?
namespace one_twice {

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return 2 * std::log(2) * h / std::log1p(1 + wh * wh);
}

}  // namespace one_twice

// Says: The spring is not looked at: omega is not used.
// Hint: A soft spring loses less in a step than a stiff one. By what is a step divided to be a number
//       without unit?
namespace no_omega {

double implicit_half_life(double omega, double h) {
    return 2 * std::log(2) * h / std::log1p(h * h);
}

}  // namespace no_omega

// Says: The logarithm of two is missing: does one half itself stand in its place, or is this the time constant of
//       the energy, or of an area?
// Hint: Factors multiply, so it is their logarithms that are shared out among the steps. What is the
//       logarithm of two?
namespace half_for_its_logarithm {

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return h / std::log1p(wh * wh);
}

}  // namespace half_for_its_logarithm

// Says: This is twice the time.
// Hint: The factor of a step is one over the root of 1 + omega² h². Its logarithm has one half in front,
//       and only one.
namespace twice_the_time {

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return 4 * std::log(2) * h / std::log1p(wh * wh);
}

}  // namespace twice_the_time

// Says: The number of steps is divided by h, where it has to be multiplied: this has the unit 1/s.
// Hint: First find a number of steps. Then multiply it by the seconds that one of them takes.
namespace no_h {

double implicit_half_life(double omega, double h) {
    const double wh = omega * h;
    return 2 * std::log(2) / h / std::log1p(wh * wh);
}

}  // namespace no_h

// Says: The square has got outside: you square the logarithm, and not omega h.
// Hint: Which of the two is a side of a triangle? Square it before you add the 1.
namespace logarithm_squared {

double implicit_half_life(double omega, double h) {
    const double logarithm = std::log1p(omega * h);
    return 2 * std::log(2) * h / (logarithm * logarithm);
}

}  // namespace logarithm_squared

// Says: The amplitude is taken to fall along a line: each step takes off as much as the first. It takes off the
//       same share of what is left.
// Hint: After n steps the amplitude is a power, share to the n. For which n is that a half?
namespace along_a_line {

double implicit_half_life(double omega, double h) {
    const double kept = 1 / std::hypot(1, omega * h);
    return h / (2 * (1 - kept));
}

}  // namespace along_a_line
