// Chapter 4, exercise 5: air for Verlet
//
// Feathers and cloth need air: a drag that slows them by $γ$ times their velocity. Rope codes
// shorten the displacement by a fixed part in each step, and so a feather falls otherwise at 30
// Hz than at 60 Hz. Write Verlet's step such that it falls alike at every frame rate: from two
// positions on the exact path, under a constant acceleration a and the drag, it must land on the
// exact path.
//
//   before    position one step ago, in metres
//   now       position now, in metres
//   a         acceleration by the force without the drag (a feather's: gravity), constant over the
//             two steps, in metres per second squared
//   gamma     the drag: the motion is $x'' = a − γ x'$, in 1/s; zero or more. Zero is no drag,
//             and Verlet. Values between zero and 0.01 do not occur
//   h         the step, in seconds (greater than zero); $γ$ times $h$ may be large
//   returns   the next position, in metres
//
// On the exact path $x = A + B \exp(−γ t) + C t$. Put it into $x'' = a − γ x'$ to find $C$; A and
// B can be anything.
//
// Example: gamma = ln 2 = 0.6931..., $h = 1$: each second halves a velocity that nothing drives.
// `damped_verlet_step(0, 8, 0, 0.6931471805599453, 1)` is 12.
//
// What is checked: without drag it is Verlet; a velocity that nothing drives dies down by the
// same factor in a second at every frame rate, and never turns round; a body that falls as fast
// as the drag lets it goes on so; exact paths go on exactly, also where $γ$ times $h$ is large;
// $γ = 0$.

#include "exercise.hpp"

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return not_started;  // your answer
}
