// Chapter 2, exercise 5: the damping of a sign in the wind, from a video
//
// A gust has set a shop sign swinging, and you have a video of it. You measure two peaks on the
// same side, the first one and one that comes some full periods later. The sign swings as a damped
// spring with a damping ratio below 1. Which ratio? It must be exact, not only for small damping.
//
//   first     height of the first peak above the position of rest, in any unit, not zero
//   later     height of the later peak, same unit, same sign, not larger in size, not zero
//   swings    full periods between the two, 1 or more
//   returns   damping ratio $ζ$, without unit, from 0 to below 1
//
// Example: a peak of 10 and, one full period later, a peak of 5 give 0.109653.
//
// What is checked: equal peaks mean no damping; the ratio that comes out makes an oscillation
// shrink by just what was measured, for weak and for strong damping; one pair of peaks or another
// of the same motion; the unit and the side make no difference; stronger damping gives more.

#include "exercise.hpp"

double zeta_from_swings(double first, double later, int swings) {
    // [answer]
    const double decrement = std::log(first / later) / swings;
    return decrement / std::hypot(2 * std::numbers::pi, decrement);
    // [answer]
}
