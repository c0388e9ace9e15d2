// Other steps of the course.

// Says: This is the passive step: the momentum of the beginning with the spin of the end. It has order one, and
//       takes energy.
// Hint: Both ends count one half, in the spin and in the momentum: the mean of two torques. Which is the one at
//       the end, to first order in the change?
namespace passive {

Vector3d half_step_jacobian(const Vector3d& inertia, const Vector3d& omega, double h) {
    return solve_linear(matrix_of(inertia, inertia, omega, 0, h), inertia.cwiseProduct(omega));
}

}  // namespace passive
