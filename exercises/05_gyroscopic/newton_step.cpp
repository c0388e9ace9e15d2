// Chapter 5, exercise 5: one iteration of Newton-Raphson
//
// A cargo ship tumbles. Its load lies askew, so its inertia tensor is a full matrix. Your solver
// does not begin at the old spin: it has a better guess of the new one, from the steps before.
// Improve that guess by one iteration of Newton-Raphson.
//
// Implicit Euler asks for the $ω₂$ that makes the residual zero,
//
//     f(ω₂) = I (ω₂ − ω₁) + h ω₂ × (I ω₂).
//
// One iteration lays the tangent to $f$ at the guess and goes to where the tangent is zero.
//
//   inertia  tensor I in the body's axes, kg m^2: symmetric, of any body whose largest moment is
//            at most 100 times the least; all nine numbers count
//   omega1   spin at the beginning of the step, in the body's axes, rad/s
//   guess    of the spin at the end of the step, in the body's axes, rad/s
//   h        length of the step, s (zero or more; $h |ω₁|$ and $h |guess|$ are at most 0.5)
//   returns  the better guess, rad/s, in the body's axes
//
// Example: with $h = 0.1$, $ω₁ = (3, 0, 1)$ and the guess (2, 2, 1) the answer is (3.1, 0.1, 0.6)
// for the inertia tensor with the rows (4, 2, 0), (2, 4, 0), (0, 0, 6).
//
// What is checked: a step of zero and a ball are solved in one iteration; a guess that is the root
// stays; where the tangent at the guess is zero; half the error of the guess leaves a quarter of
// the error; a few iterations find the root; a body that lies in other axes is stepped alike. Ten
// digits count: take the Jacobian from the product rule, not from differences.
//
// `solve_linear(A, b)` is there for you: the $x$ with $A x = b$, for any matrix.

#include "exercise_eigen.hpp"

Vector3d newton_step(const Matrix3d& inertia, Vector3d omega1, Vector3d guess, double h) {
    return not_started;  // your answer
}
