// Chapter 4, exercise 3: a rope between two weights
//
// A grappling hook ties the player to a crate, or to a wall. Verlet has moved both ends; now put
// the rope to its length again, once: position-based dynamics (PBD) calls it constraint projection.
// A rope can only pull: if the ends are nearer than its length, it hangs loose and does nothing.
// The chapter's rope shares the excess in halves. Here the ends have masses, and each moves in
// proportion to its inverse mass 1/m. A wall has the inverse mass 0.
//
//   a, b      positions of the two ends, in metres
//   wa, wb    inverse masses of a and of $b$, in 1/kg; zero for an end that is held
//   length    of the rope, in metres (greater than zero)
//   returns   `{a, b}`, the new positions. The two ends move only along the line between them.
//             Where the rope is loose, or both ends are held, they are those given
//
// Example: a at the origin with 1 kg, $b$ at (4, 0, 0) with 3 kg, a rope of 2 m. It is 2 m too
// long: a moves by 3/4 of that and $b$ by 1/4.
// `tighten_rope({0, 0, 0}, {4, 0, 0}, 1, 1.0 / 3, 2)` is `{(1.5, 0, 0), (3.5, 0, 0)}`.
//
// What is checked: loose ropes and ropes between two walls; ends in the same place; a tight rope
// gets its length, be it too long by a hair; a wall does not move; the ends move along the rope and
// keep their common centre of mass; in other units of mass the answer is the same.

#include "exercise_eigen.hpp"

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    // [answer]
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (distance - length) / (wa + wb) * (apart / distance);
    return {a + wa * pull, b - wb * pull};
    // [answer]
}
