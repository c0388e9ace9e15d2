// Chapter 5, exercise 1: can this be a body?
//
// Your game reads the moments of inertia of each body from a file. An artist typed them in, and a
// wrong one makes the solver blow up much later. Find it at loading: can a rigid body have these
// three moments at all?
//
// The moments are sums over all the pieces of the body, each with its mass m, which is never
// negative, and its place $(x, y, z)$:
//
//     inertia_x = \text{sum of }m (y² + z²)
//     inertia_y = \text{sum of }m (z² + x²)
//     inertia_z = \text{sum of }m (x² + y²)
//
// A piece that adds to one of them adds to another, too. So no moment can be as large as you like
// beside the other two. The mass may be spread in any way that gives three moments above zero. All
// of it on one line gives a zero, by which a solver would divide: such a file is wrong. All of it
// in one plane, a flat plate, is fine.
//
//   inertia   three numbers from the file, in kg m²: finite, of any sign or zero, of any size from
//             1e-20 to 1e20
//   returns   true where a body can have them as its moments
//
// You need no tolerance: the plates in the tests are whole numbers times a power of two, which add
// up without rounding. You may use one, up to a billionth of the largest moment: a share of it, not
// a fixed number, which would be all that a small body has.
//
// Example: `is_a_body({4, 5, 8})` is true. So is `is_a_body({4, 5, 9})`: a plate.
// `is_a_body({4, 5, 10})` is false.
//
// What is checked: clouds of masses are bodies, and so are flat plates, whichever way they lie; a
// moment that is a little or much too large, of large and of tiny bodies; moments that are zero or
// negative; from where to where a third moment may go; the unit and the order of the axes do not
// matter.

#include "exercise_eigen.hpp"

bool is_a_body(const Vector3d& inertia) {
    return not_started;  // your answer
}
