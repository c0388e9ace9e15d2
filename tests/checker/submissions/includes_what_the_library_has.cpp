// half_step_jacobian does_not_compile: includes include/timestep/gyroscopic/half_step_jacobian.hpp
#include "exercise_eigen.hpp"

#include <timestep/gyroscopic/half_step_jacobian.hpp>

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    const timestep::PrincipalInertia<double> body(inertia.x(), inertia.y(), inertia.z());
    return timestep::half_step_jacobian.step(body, omega, h);
}
