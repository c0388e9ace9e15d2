// Chapter 8, exercise 4: a flywheel on board
//
// In your space game a ship tumbles with a flywheel on board. The wheel spins in its bearings at a
// constant rate and gives the ship an angular momentum more, which is constant in the ship's own
// axes. The ship must survive any step: a pause of hours, a spin of an exploding engine.
//
// Take $L$ from the old spin $w₁$, with the wheel in it, and let it act on the new spin $w₂$:
//
//     I (w₂ − w₁) = h L₁ × w₂ \quad\text{with}\quad L₁ = I w₁ + wheel
//
// The torque on the right is at right angles to $w₂$, so the energy w.Iw/2 never grows. Solve it.
//
//   inertia  the three moments about the ship's own axes, in kg m^2 (1e-5 to 1e6; of any body whose
//            largest moment is at most 1000 times the least)
//   wheel    angular momentum of the wheel, in the ship's axes, in kg m^2/s; may be zero, or much
//            larger than the ship's own, up to 1e12
//   omega    the old spin $w₁$, in the ship's axes, in rad/s; may be zero, up to 1000
//   h        length of the step, in s: 0 to 1e6
//   returns  the new spin $w₂$, in the ship's axes, in rad/s
//
// Twelve digits count, however long the step. A general solver, or an inverse of a matrix, loses
// them in long steps: the energy grows. So solve the equation by hand.
//
// Example: $inertia = (4, 2, 3)$, $wheel = (1, 0, 0)$, $ω = (1, 1, 2)$ and $h = 1$ give (1.3,
// 0.4, 1.8).
//
// What is checked: no time, no spin, a spin about the wheel's own axis, and a ball without a wheel;
// the energy never grows, from short steps to the longest; what the torque cannot change; which way
// it acts; the equation itself, also without a wheel.

#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    return not_started;  // your answer
}
