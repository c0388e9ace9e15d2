// Chapter 5, exercise 6: wreckage that keeps its energy
//
// Wreckage tumbles through your space game for minutes. With the talk's solver it slows down by
// itself: that solver takes the gyroscopic torque of the end of the step alone, as the tangent at
// the beginning foretells it. Do better for the same price, one linear solve a step: let the mean
// of two torques act during the step, that of the beginning and that of the end. The one of the
// end is again the one that the tangent foretells.
//
// This has order two. It runs backwards, too: a step of -h leads to where a step of h came from.
//
//   inertia  the principal moments (I1, I2, I3), kg m^2 (any body's)
//   omega    spin at the beginning of the step, in the principal axes, rad/s
//   h        length of the step, s (zero, or below zero for a step back, are right, too; the size
//            of h omega is below one: near two the equations may have no solution)
//   returns  the spin at the end of the step, in the principal axes, rad/s
//
// Example: the moments (2, 3, 4) with omega = (2, 2, 4) and h = 0.125 end at (1.4375, 2.5625,
// 3.875).
//
// What is checked: a spin about a principal axis stays, and so does any spin of a ball; twice the
// spin needs half the time; a body with two equal moments keeps its energy; a step back undoes a
// step; half the step leaves a quarter of the error; the energy of a long tumble does not drift;
// the change of I omega is h times the mean of the two torques. Ten digits count.

#include "exercise_eigen.hpp"

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return not_started;  // your answer
}
