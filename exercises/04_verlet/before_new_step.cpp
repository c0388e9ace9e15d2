// Chapter 4, exercise 4: slow motion for Verlet
//
// Your game goes into slow motion: from now on its steps are shorter. Its Verlet code knows no
// changing steps and shall not learn them: it always computes $x₂ = 2 x₁ − x₀ + h² a(x₁)$, from
// now on with the new $h$. But the stored "before" is one OLD step away. Compute the one that
// belongs there now, so that plain Verlet goes on with order two.
//
//   before    position one old step ago, in metres
//   now       position now, in metres
//   a         acceleration now, in metres per second squared
//   h_old     step up to now, in seconds (greater than zero)
//   h_new     step from now on, in seconds (greater than zero; at most a thousand times longer or
//             shorter)
//   returns   the position one new step ago, in metres: where the point was or would have been
//
// Example: $x = t²$ has $a = 2$. At $t = 2$ the position is 4, and with $h_{old} = 1$ before is
// 1. A new step of 0.5 needs the position at $t = 1.5$: `before_new_step(1, 4, 2, 1, 0.5)` is
// 2.25.
//
// What is checked: without a change nothing changes; constant velocity and constant acceleration
// come out exactly, for shorter and for longer steps; changing the step and changing it back undoes
// itself; a run of Verlet on a spring whose step changes all the time has order two.

#include "exercise.hpp"

double before_new_step(double before, double now, double a, double h_old, double h_new) {
    return not_started;  // your answer
}
