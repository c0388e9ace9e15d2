// Chapter 6, exercise 4: how long the next step should be
//
// A space game follows a probe: for months nothing happens, then it flies past a moon. You take
// each step twice, whole and in two halves, and their difference tells the error. In the chapter
// the method had order one. Now it may have any order: one step of $h$ is off by
// $C h^{order + 1}$, with a $C$ that is the same for the whole step, for each of its halves and
// for the next step. (Nearly so, when steps are short.)
//
//   whole      what one step of $h$ gives
//   halves     what two steps of $h/2$ give; both in any unit, of any size, or not finite
//   h          length of the whole step, in s (1e-9 to 1e6)
//   tolerance  how far off the two halves may be together, in the unit of the results (1e-12 to
//              1e6)
//   order      of the method (1 to 8)
//   returns    the length of the next whole step, s
//
// Find the step whose two halves would together be off by the tolerance. Return 0.9 times that
// step, for a margin; but never more than $5 h$ nor less than $h/5$. Where the results are not
// numbers, or infinite, the step was far too long: $h/5$. Where they agree to the last bit:
// $5 h$.
//
// Example: `next_step(1.03, 1, 0.1, 0.01, 2)` is 0.09, since the halves are off by 0.01, just as
// far as they may.
//
// What is checked: results that agree; results that are not finite; the limits; for a motion
// whose error is $C h^{order + 1}$, what the halves of the next step are off by; how the answer
// follows the tolerance; the unit, the sign and the size of the results; where a few tries lead
// from steps much too long or too short.

#include "exercise.hpp"

double next_step(double whole, double halves, double h, double tolerance, int order) {
    // [answer]
    // With E = C h^(order + 1) the whole step is off by E and the halves by 2 E / 2^(order + 1), so
    // their difference is 2^order - 1 times what the halves are off by.
    const double error = std::fabs(whole - halves) / (std::exp2(order) - 1);
    if (!std::isfinite(error)) return h / 5;
    if (error == 0) return 5 * h;
    const double factor = 0.9 * std::pow(tolerance / error, 1.0 / (order + 1));
    return h * std::clamp(factor, 0.2, 5.0);
    // [answer]
}
