// Chapter 1, exercise 5: the optimal step size for an acceleration
//
// A tracker gives you positions, and you need the acceleration, to shake a controller with. From
// three positions that lie $h$ apart it is $(x₂ − 2 x₁ + x₀)/h²$, the acceleration at the moment
// of $x₁$. The tracker's noise is now divided by $h²$, so a wrong $h$ costs even more than it
// does for a velocity. Which $h$ is best?
//
//   noise        how far off each of the three positions may be, to either side, in metres (above
//                zero)
//   snap         the largest |x⁗|, the fourth derivative of the position by time, in metres per
//                second to the fourth (above zero)
//   returns      the step $h$ for which the worst error of the acceleration is smallest, in
//                seconds; an error of five parts in 10⁸ is allowed, so a search for the minimum
//                will do
//
// The worst error is, as in the chapter, the sum of two: the leading term of what the formula cuts
// off, with the largest snap, and the noise at its worst in all three positions together.
//
// Example: `best_acceleration_step(0.0005, 240)` is 0.1: positions rounded to a grid of a
// millimetre, and a hand that shakes quickly.
//
// What is checked: the step has the right unit, so it scales as it must with metres and with
// seconds; no other step has a smaller worst error, be it microseconds or minutes; for a real swing
// with the worst noise the acceleration is better at your step than at longer and at shorter ones.

#include "exercise.hpp"

double best_acceleration_step(double noise, double snap) {
    return not_started;  // your answer
}
