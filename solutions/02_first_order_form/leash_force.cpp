// Chapter 2, exercise 6: a ball on a leash
//
// A ball is tied to its owner by an elastic leash. You know its position and its velocity as the
// owner sees them, and need the force on the ball. The leash is a spring with a rest length, and
// a damper along it: the tension is $k$ times the stretch, plus $c$ times the rate at which the
// leash gets longer. What moves across the leash is not damped. A leash only pulls: not longer
// than its rest length, it is slack and has no force; and where the sum of spring and damper is
// below zero there is none, either. The ball may be exactly where its owner is.
//
//   x         position of the ball less that of its owner, in m; may be zero
//   v         velocity of the ball less that of its owner, in m/s
//   k         stiffness, above zero, in N/m
//   c         damping, zero or more, in N·s/m
//   length    rest length, zero or more, in m
//   returns   force on the ball, in N
//
// Example: $x = (3, 0, 4)$ and $v = (1, 7, 2)$ with $k = 10$, $c = 2$ and $length = 4$ give
// (−8.64, 0, −11.52).
//
// What is checked: a slack leash, one as long as at rest, one longer by a hair, one of no rest
// length, and a ball at its owner's place; at rest the spring pulls back along the leash; what moves
// across does not matter; no damping, and little; the damper takes just the energy that it should;
// no pushing; the force turns with the scene.

#include "exercise_eigen.hpp"

Vector3d leash_force(const Vector3d& x, const Vector3d& v, double k, double c, double length) {
    // [answer]
    const double distance = x.norm();
    if (distance <= length) return Vector3d::Zero();  // slack, and never a division by zero
    const Vector3d outwards = x / distance;
    const double tension = k * (distance - length) + c * v.dot(outwards);
    return -std::max(tension, 0.0) * outwards;
    // [answer]
}
