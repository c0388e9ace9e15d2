// Chapter 3, exercise 4: a constraint that gives way like a spring
//
// A wheel hangs on a car. The physics engine's solver knows no springs: it asks for an impulse
// $J$ that corrects the wheel's velocity from $v₁$ to $v₂ = v₁ + J / mass$, such that
//
//     v₂ + (β / h) C + γ J = 0.
//
// $C$ is the wheel's distance from where it belongs, in m. The error reduction $β$ says which
// share of $C$ the step is to take back, and the softness $γ$ how far the constraint gives way.
// Nobody can tune these two by feel. A designer gives $ω$ and $ζ$. Find the $γ$ and $β$ with
// which $v₂$ is what implicit Euler makes of a spring with a damper: it starts at $x₁ = C$ with
// the velocity $v₁$, and its acceleration is $−ω² x − 2 ζ ω v$.
//
//   mass     of the wheel, kg (above zero)
//   omega    angular frequency of the spring, rad/s (1e-3 to 1e6)
//   zeta     damping ratio, no unit (zero to 100)
//   h        length of the step, s (at most 1; $ω h$ is 0.001 to 100)
//   returns  `{gamma, beta}`: $γ$ in 1/kg, $β$ without a unit; one part in 10⁹ off is near enough
//
// Example: `soft_constraint(2, 10, 1, 0.1)` is `{1/6, 1/3}`: a third of the error in one step.
//
// What is checked: with $γ$ and $β$ the solver's $v₂$ obeys the equation of implicit Euler,
// whatever $C$ and $v₁$, with weak dampers and strong ones, in short steps and long; $β$ lies
// between zero and one; without a damper it is one; a very stiff spring becomes a rigid
// constraint; the mass and $ω h$ act as they should.

#include "exercise.hpp"

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    return not_started;  // your answer
}
