// Chapter 3, exercise 2: a camera that survives a hitch
//
// Your camera follows the player on a spring with a damper. When a level loads, a frame takes half
// a second, and the camera flies off. Step it with implicit Euler: it cannot blow up, however long
// the frame. The force is linear, so one division solves the step.
//
// The camera's acceleration is $−ω² (x − target) − 2 ζ ω v$. Implicit Euler takes it at the new
// position and the new velocity; the position moves with the new velocity.
//
//   state    the camera now: time `state.t` in s, position `state.x` in m, velocity `state.v` in
//            m/s
//   target   where the player is at the end of the step, m
//   omega    angular frequency of the spring, rad/s (above zero)
//   zeta     damping ratio, no unit (zero or more)
//   h        length of the frame, s (zero, or $ω h$ is a millionth or more; it may be large)
//   returns  the state a time $h$ later, `State<double>{t, x, v}`: time, position, velocity
//
// Example: from $t = 0$, $x = 0$, $v = 0$ with $target = 1$, $ω = 2$, $ζ = 1$ and $h = 0.5$, the
// velocity becomes 0.5 and the position 0.25, at $t = 0.5$.
//
// What is checked: a camera on its target stays; the clock and the position move on; the new
// velocity obeys the equation of implicit Euler, with any damper or none; a step of zero changes
// nothing; no frame, however long, adds energy; after a very long one the camera rests on its
// target.

#include "exercise.hpp"

State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    return not_started;  // your answer
}
