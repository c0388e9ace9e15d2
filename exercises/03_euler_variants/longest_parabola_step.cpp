// Chapter 3, exercise 6: how long may this engine's step be?
//
// An engine moves each body along a parabola, which is exact for a thrown ball:
//
//     x₂ = x₁ + h v₁ + h² a₁ / 2 \quad v₂ = v₁ + h a₁
//
// where $a₁$ is the acceleration at $x₁$ and $v₁$. You put a door closer into it, a spring with a
// damper: $a = −ω² x − 2 ζ ω v$. Up to which step is the door stable?
//
//   omega    angular frequency of the spring, rad/s (above zero)
//   zeta     damping ratio, no unit (zero, or from 10⁻⁴ to 20)
//   returns  the $h$, in seconds, below which every step is stable: whatever the start, the
//            motion dies away. One part in a million off is near enough. Zero where no step is
//            stable.
//
// Example: `longest_parabola_step(10, 0.1)` is 0.04.
//
// What is checked: a little below it, and far below, a run dies away; a little above it, one
// grows; without damping no step is stable; only $ω h$ and $ζ$ count; weak damping helps, and
// strong damping does harm.

#include "exercise.hpp"

double longest_parabola_step(double omega, double zeta) {
    return not_started;  // your answer
}
