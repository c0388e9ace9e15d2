// Submissions that do not compile, or are not the learner's own. Above each stands its name, and in its
// first line what the checker must say of it:  // EXERCISE VERDICT: words that the message must hold, if any

// ---- includes the solution
// velocity_now does_not_compile: includes solutions/01_derivatives/velocity_now.cpp
#include "exercise.hpp"

#include "SOURCE/solutions/01_derivatives/velocity_now.cpp"

// ---- includes what the library has
// half_step_jacobian does_not_compile: includes include/timestep/gyroscopic/half_step_jacobian.hpp
#include "exercise_eigen.hpp"

#include <timestep/gyroscopic/half_step_jacobian.hpp>

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const timestep::PrincipalInertia<double> body(inertia.x(), inertia.y(), inertia.z());
    return timestep::half_step_jacobian.step(body, omega, h);
}

// ---- an empty file
// velocity_now does_not_compile: The file has no function

// ---- returns a float
// velocity_now does_not_compile: otherwise than the exercise does: double velocity_now(double x0,
#include "exercise.hpp"

float velocity_now(double x0, double x1, double x2, double h) { return (3 * x2 - 4 * x1 + x0) / (2 * h); }

// ---- an unused variable
// velocity_now pass: The compiler remarks:
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    const double middle = (x2 - x0) / 2;
    return (3 * x2 - 4 * x1 + x0) / (2 * h);
}
