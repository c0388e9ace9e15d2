// Chapter 5, exercise 2: what a torque does to a spaceship
//
// Your engine keeps everything in world coordinates: the spin of a spaceship, and the torque of its
// thrusters. Only the moments of inertia are known along the ship's own axes. How fast does the
// spin change? Use Euler's equations, with the gyroscopic torque in them.
//
//   inertia   the three moments along the body's own axes, in kg m²: of any body, also a long rod,
//             whose largest moment is up to a million times the least
//   q         orientation, of length one: `q * v` is in world coordinates what $v$ is in the
//             body's. In Eigen `q.conjugate()` turns back
//   omega     angular velocity in world coordinates, in rad/s; may be zero
//   torque    in world coordinates, in N m; may be zero
//   returns   angular acceleration in world coordinates, in rad/s²
//
// What Eigen offers for this: a.cwiseProduct(b) multiplies and a.cwiseQuotient(b) divides
// component by component, a.cross(b) is a × $b$, and `q * v` turns a vector.
//
// Example: a ship with $inertia = (2, 4, 5)$ is turned by a quarter about $z$: its own $x$ axis
// is the world's $y$ axis. With $ω = (0, 3, 2)$ and $torque = (2, 6, 5)$ the answer is (−4, 3,
// 1).
//
// What is checked: bodies at rest, balls, and spin about one of the body's own axes; the torque's
// power is what the energy gains; the angular momentum changes at the rate of the torque; the part
// that the torque adds, and the part that the spin adds; the answer turns with the scene.

#include "exercise_eigen.hpp"

Vector3d world_acceleration(Vector3d inertia, Quaterniond q, Vector3d omega, Vector3d torque) {
    return not_started;  // your answer
}
