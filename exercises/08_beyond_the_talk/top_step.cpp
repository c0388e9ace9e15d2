// Chapter 8, exercise 5: a top that never forgets
//
// A wooden top dances on a table in your game: its tip stays where it is, and it may have three
// different moments. Everything is kept in the top's own axes: its angular momentum $L$ about the
// tip, and the direction up, which tells how it leans. Its centre of mass is on its $z$ axis.
// Then
//
//     L' = L × ω + mgl (up × z) \quad\text{with}\quad ω = (L_x/I_x, L_y/I_y, L_z/I_z), \quad z = (0, 0, 1)
//     up' = up × ω
//
// Split the motion: gravity alone, the spin about $x$ alone, about $y$ alone, about $z$ alone.
// Each part by itself you can solve exactly. Put them together so that the step has order two and
// reads the same from both ends, gravity first and last, then $x$, then $y$, and $z$ in the
// middle.
//
//   inertia  the moments about the tip, along the top's own axes, in kg m^2 (1e-5 to 1e3; of
//            any body whose largest moment is at most ten times the least)
//   mgl      mass times gravity times the height of the centre of mass above the tip, when the top
//            stands upright, in N m; may be zero, or below zero: then it hangs
//   L        angular momentum about the tip, in the top's axes, in kg m^2/s; may be zero
//   up       the vertical, upwards, in the top's axes, of length one
//   h        length of the step, in s; may be zero, below zero (back in time), and much too long:
//            the top may turn by a thousand radians in it
//   returns  `{L, up}` at the end of the step
//
// What Eigen offers for this: `Eigen::AngleAxisd(angle, Vector3d::Unit(i))` * $v$ turns $v$ about
// axis $i = 0$, 1 or 2 by an angle, counterclockwise when the axis points at you.
//
// Example: the moments (2, 3, 4) with $mgl = 0$, $L = (0, 0, 4)$, $up = (0.6, 0, 0.8)$ and
// $h = 0.5$ end at $L = (0, 0, 4)$ and $up = (0.5265, −0.2877, 0.8)$, rounded.
//
// What is checked: no time; a top at rest, upright or hanging; spin about one axis, without
// gravity; a tilted top that is let go; the length of up, and without gravity of $L$; the
// momentum about the vertical; each for any step; the step back; half the step leaves a quarter
// of the error; the energy of a long dance. Eleven digits count.

#include "exercise_eigen.hpp"

std::array<Vector3d, 2> top_step(Vector3d inertia, double mgl, Vector3d L, Vector3d up, double h) {
    return not_started;  // your answer
}
