// Chapter 3, exercise 5: how much room a simulated spring needs
//
// A wrecking ball swings on a spring without a damper, stepped with semi-implicit Euler, and must
// not touch the wall. The true motion would stay within $\sqrt{x² + v² / ω²}$. The simulated one
// goes farther: its states lie on an ellipse that leans over, since it keeps another energy than
// the true one. How far from $x = 0$ does that ellipse reach?
//
// Semi-implicit Euler takes the spring at the old position, and then moves the position with the
// new velocity.
//
//   x        position at some moment of the run, from where the spring is relaxed, m
//   v        velocity at the same moment, m/s
//   omega    angular frequency of the spring, rad/s (above zero)
//   h        length of a step, s (above zero, and $ω h$ below 2, by a millionth at least)
//   returns  the largest $|x|$ on the ellipse through this state, m. It need not be the position
//            of a step: at $ω h = 1$, say, the run has only six states, and passes by that point.
//
// Example: `farthest_reach(1, 0, 1, 1)` is 1.1547: the ball was let go at 1, but its ellipse
// reaches farther.
//
// What is checked: at rest in the middle it is zero, and it scales with the state; each state of
// a run gives the same answer; no position of a long run is farther, and a long run gets as near
// as you like where it does not repeat itself; steps with $ω h$ close to 2; with short steps it
// is that of the true motion.

#include "exercise.hpp"

double farthest_reach(double x, double v, double omega, double h) {
    return not_started;  // your answer
}
