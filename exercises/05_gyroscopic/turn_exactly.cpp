// Chapter 5, exercise 3: a headset that turns
//
// A gyroscope in a VR headset measures how fast the player's head turns, about the axes of the
// headset itself. The chapter's step of the orientation takes a spin in world coordinates, and does
// not turn quite far enough. Here the spin is in the body's axes, and stays the same for the whole
// step. The turn that it makes can be computed exactly.
//
//   q         orientation at the start, of length one: `q * v` is in world coordinates what $v$
//             is in the body's
//   omega     angular velocity in the body's own axes, constant, in rad/s; may be zero, or tiny
//   h         length of the step, in s; zero, long or negative (then back in time), too
//   returns   the orientation after $h$ seconds, of length one, with all its digits
//
// An angle of 1e-9 is a turn, too. A spin of 1e-14 turns the body when $h$ is long enough. A step
// may take a hundred thousand turns; then only rounding may cost digits. $q$ and $−q$ are one
// orientation, and you may return either. `Quaterniond(w, x, y, z)` has the cosine first;
// coeffs() has it last.
//
// Example: q = `Quaterniond(0.8, 0, 0, 0.6)`, $ω = (3, 0, 0)$ and $h = 0.5$ give
// `Quaterniond(0.5854, 0.5453, 0.4090, 0.4390)`, all rounded.
//
// What is checked: no time; the length; where the axis points; by what angle a point goes round it,
// which way, after many turns as well as for tiny angles; slow spins, and none; two steps in a row;
// the answer turns with the scene.

#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond& q, const Vector3d& omega, double h) {
    return not_started;  // your answer
}
