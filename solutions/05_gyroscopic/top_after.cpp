// Chapter 5, exercise 4: a top, any time later
//
// Players throw a rugby ball. The server sends its spin at one moment only, and each player's
// game wants to know it at any other, later or earlier, without a step in between. The ball flies
// without a torque. Its axis of symmetry is the $z$ axis of the body. The moments about the
// body's $x$, $y$ and $z$ axes are across, across and along. For such a body Euler's equations
// have a solution in closed form: find it.
//
//   across    moment about the body's $x$ axis, and about its $y$ axis, in kg m² (above zero)
//   along     moment about the axis of symmetry, $z$, in kg m² (above zero, at most 2 across).
//             The two are equal for a sphere
//   omega     angular velocity at the start, in the body's own axes, in rad/s; may be zero, along
//             $z$, across it, or nearly along $z$: a wobble of 1e-12 rad/s goes round, too
//   t         how much later, in s; zero or negative (earlier), too
//   returns   angular velocity then, in the body's own axes, which have turned with the body, in
//             rad/s. Exact but for rounding
//
// Example: `top_after(2, 1, {3, 0, 4}, 0.5)` is (1.6209, −2.5244, 4), rounded.
//
// What is checked: no time; spheres, spin along the axis and spin across it; what stays; which way
// the rest turns; two flights in a row, and back; Euler's equations, at any time; how long a turn
// takes; tiny wobbles; bodies that are nearly round.

#include "exercise_eigen.hpp"

Vector3d top_after(double across, double along, const Vector3d& omega, double t) {
    // [answer]
    // The part along z stays. Euler's equations turn the part across at a constant rate.
    const double rate = (along - across) / across * omega.z();
    const double c = std::cos(rate * t), s = std::sin(rate * t);
    return {c * omega.x() - s * omega.y(), s * omega.x() + c * omega.y(), omega.z()};
    // [answer]
}
