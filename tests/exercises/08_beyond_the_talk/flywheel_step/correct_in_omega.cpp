#include "exercise_eigen.hpp"

Vector3d flywheel_step(Vector3d inertia, Vector3d wheel, Vector3d omega, double h) {
    // Without roots: the equation is (1 - S) w2 = w1 with S = h I^-1 [L1], whose cube is -s S.
    const Vector3d V = inertia.cwiseInverse();
    const Vector3d l = h * (inertia.cwiseProduct(omega) + wheel);
    const Vector3d S_w = V.cwiseProduct(l.cross(omega));
    const double s = l.cwiseProduct(l).dot(inertia) * V.prod();
    const Vector3d rest = V.prod() * inertia.cwiseProduct(omega).dot(l) * l;
    return (omega + S_w + rest) / (1 + s);
}
