// Chapter 6, exercise 1: how many steps a frame
//
// A crate hangs on springs, side by side, which all pull it back along one line. You step it with
// semi-implicit Euler. A designer may change every number, so your game counts the steps when a
// level is loaded: it cuts each frame into equal steps, as few as are safe.
//
// Without a damper, semi-implicit Euler is stable below $ω h = 2$. For a margin you allow only a
// share of that: $ω h$ may be as large as $2 share$, and no larger.
//
//   mass       of the crate, kg (1e-6 to 1e6)
//   springs    how many there are (0 to 1000)
//   stiffness  of each spring, N/m (zero or more)
//   frame      length of a frame, s (1e-4 to 1)
//   share      of the limit that you allow, no unit (0.01 to 1)
//   returns    the least number of equal steps in a frame with which $ω h$ is at most $2 share$:
//              1 or more. The numbers that are drawn need at most 100,000 steps.
//
// Where $ω h$ misses $2 share$ by less than one part in a billion, it is too close to call: the
// tests do not ask there. By more than that, they do.
//
// Example: `substeps(5, 4, 50000, 0.0149, 0.5)` is 3: $ω$ is 200 rad/s, a whole frame has
// $ω h = 2.98$, and 1 is allowed. With frames of 0.0151 s it is 4.
//
// What is checked: a crate that nothing pulls, and slow ones; with the answer $ω h$ is small
// enough, and with a step fewer too large, by much or by very little; a run with so many steps
// stays bounded; several springs and one that is as stiff as all of them.

#include "exercise.hpp"

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    // [answer]
    // Springs side by side pull together: their stiffnesses add up.
    const double omega = std::sqrt(springs * stiffness / mass);
    const double least = omega * frame / (2 * share);
    return std::max(1, static_cast<int>(std::ceil(least)));
    // [answer]
}
