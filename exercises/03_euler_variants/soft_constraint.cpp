// Chapter 3, exercise 4: a constraint that gives way like a spring
//
// A wheel hangs on a car. The physics engine's solver knows no springs: it asks for an impulse J
// that corrects the wheel's velocity from v1 to v2 = v1 + J / mass, such that
//
//     v2 + (beta / h) C + gamma J = 0.
//
// C is the wheel's distance from where it belongs, in m. The error reduction beta says which share
// of C the step is to take back, and the softness gamma how far the constraint gives way. Nobody
// can tune these two by feel. A designer gives omega and zeta. Find the gamma and beta with which
// v2 is what implicit Euler makes of a spring with a damper: it starts at x1 = C with the velocity
// v1, and its acceleration is -omega² x - 2 zeta omega v.
//
//   mass     of the wheel, kg (above zero)
//   omega    angular frequency of the spring, rad/s (1e-3 to 1e6)
//   zeta     damping ratio, no unit (zero to 100)
//   h        length of the step, s (at most 1; omega h is 0.001 to 100)
//   returns  {gamma, beta}: gamma in 1/kg, beta without a unit; one part in 10⁹ off is near enough
//
// Example: soft_constraint(2, 10, 1, 0.1) is {1/6, 1/3}: a third of the error in one step.
//
// What is checked: with gamma and beta the solver's v2 obeys the equation of implicit Euler,
// whatever C and v1, with weak dampers and strong ones, in short steps and long; beta lies between
// zero and one; without a damper it is one; a very stiff spring becomes a rigid constraint; the
// mass and omega h act as they should.

#include "exercise.hpp"

std::array<double, 2> soft_constraint(double mass, double omega, double zeta, double h) {
    return not_started;  // your answer
}
