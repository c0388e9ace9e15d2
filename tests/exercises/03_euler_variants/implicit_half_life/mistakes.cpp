#include "exercise.hpp"

// Says: This takes the determinant for the factor of the amplitude: 1/(1 + omega² h²) is what a step does to
//       an area.
// Hint: An area shrinks in two directions at once. What is left for each of them?
namespace determinant {

double implicit_half_life(double omega, double h) {
    return std::log(2) * h / std::log(1 + omega * omega * h * h);
}

}  // namespace determinant

// Says: This is the time after which the amplitude is 1/e of what it was, the time constant.
// Hint: You are asked for a half: which logarithm is missing?
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
