// Chapter 5, exercise 6: wreckage that keeps its energy
//
// Wreckage tumbles through your space game for minutes. With the talk's solver it slows down by
// itself. That solver lets the gyroscopic torque of the end of the step act alone. It does not
// know the spin there yet, so it linearises: it follows the tangent to the torque, a function of
// the spin, from $ω$ to the spin it looks for.
//
// Do better for the same price, one linear solve a step. Let the mean of two torques act: the one
// at $ω$, and the one of the end, linearised about $ω$ as before.
//
// This has order two. It runs backwards, too: a step of $−h$ leads to where a step of $h$ came
// from.
//
//   inertia  the principal moments $(I₁, I₂, I₃)$, kg m^2 (of any body; the largest is at most
//            1000 times the least)
//   omega    spin at the beginning of the step, in the principal axes, rad/s
//   h        length of the step, s (may be zero, or below zero for a step back; the length of
//            $h ω$ is below one, for near two the equations may have no solution)
//   returns  the spin at the end of the step, in the principal axes, rad/s
//
// Example: the moments (2, 3, 4) with $ω = (2, 2, 4)$ and $h = 0.125$ end at (1.4375, 2.5625,
// 3.875).
//
// What is checked: a spin about a principal axis stays, and so does any spin of a ball; a step of
// zero changes nothing; twice the spin needs half the time; a body with two equal moments keeps
// its energy; a step back undoes a step; half the step leaves a quarter of the error; the energy
// of a long tumble does not drift; I $ω$ changes by $h$ times the mean of the two torques. Twelve
// digits count: linearise with the product rule, not with differences.
//
// `solve_linear(A, b)` is there for you: the $x$ with $A x = b$, for any matrix.

#include "exercise_eigen.hpp"

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    // [answer]
    // About omega the torque is torque - G d, when the spin has changed by d. Half of each end:
    // I d = h (torque - G d / 2).
    const auto skew = [](const Vector3d& a) {
        return Matrix3d{{0, -a.z(), a.y()}, {a.z(), 0, -a.x()}, {-a.y(), a.x(), 0}};
    };
    const Matrix3d I = inertia.asDiagonal();
    const Vector3d torque = -omega.cross(I * omega);
    const Matrix3d G = skew(omega) * I - skew(I * omega);
    const Matrix3d jacobian = I + h / 2 * G;
    return omega + solve_linear(jacobian, h * torque);
    // [answer]
}
