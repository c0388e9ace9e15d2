// Chapter 3, exercise 3: a parachute opens
//
// A falling character opens a parachute. The drag jumps to a hundred times what it was, and with
// explicit Euler the next step throws the character back into the sky. Implicit Euler cannot: it
// takes the drag at the new velocity. That is a quadratic equation, and you can solve it.
//
// Velocities point up. The acceleration is $−gravity − k |v| v$: the drag is against the motion,
// upwards or downwards. Implicit Euler takes it at the new velocity.
//
//   v        velocity at the start of the step, m/s (either sign, or zero)
//   gravity  how strongly things fall, m/s² (zero or more)
//   k        drag per unit of mass, 1/m (zero where there is no air, or more)
//   h        length of the step, s (zero or more)
//   returns  the velocity at the end of the step, m/s, with all its digits: an error of one part
//            in 10⁹ is too much, also where the air is so thin that $k h v$ is 10⁻¹⁰.
//
// Example: for $v = −12$, $gravity = 10$, $k = 0.5$ and $h = 1$ the new velocity is about
// -5.7082. Explicit Euler says +50.
//
// What is checked: without air there is only gravity; the new velocity obeys the equation of
// implicit Euler, on the way up and on the way down; drag alone never turns the motion round; in a
// long step the fall reaches the speed at which drag carries the weight; thin air costs no digits.

#include "exercise.hpp"

double velocity_under_drag(double v, double gravity, double k, double h) {
    return not_started;  // your answer
}
