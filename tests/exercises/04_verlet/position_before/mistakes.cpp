#include "exercise.hpp"

// Says: This is the position one step after now, the one with which the chapter starts Verlet.
// Hint: Try a velocity and no force: a point that flies to the right was further to the left.
namespace position_after {

double position_before(double x, double v, double a, double h) {
    return x + h * v + h * h / 2 * a;
}

}  // namespace position_after

// Says: The velocity is followed back, but the force of that step is left out, or has cancelled: the whole run
//       falls to order one. Or is there a 1/2? In C++ that is 0: write 0.5.
// Hint: The velocity given is that of now. One step before, it was another, and the way between was flown
//       with neither of the two.
namespace no_acceleration {

double position_before(double x, double v, double a, double h) {
    return x - h * v;
}

}  // namespace no_acceleration

// Says: The force enters with h² a, twice as much as it moves a point in one step.
// Hint: Let a point go at rest and count the metres of the first step: a stone falls half of a t squared.
namespace whole_acceleration {

double position_before(double x, double v, double a, double h) {
    return x - h * v + h * h * a;
}

}  // namespace whole_acceleration

// Says: The acceleration has changed its sign with the velocity. Running time backwards turns velocities
//       round, but no accelerations.
// Hint: A stone at the top of its throw: was it above that point a moment ago, or below?
namespace force_reversed {

double position_before(double x, double v, double a, double h) {
    return x - h * v - h * h / 2 * a;
}

}  // namespace force_reversed

// Says: The terms have the right signs, but the step is missing: metres per second are taken off metres.
// Hint: Look at the units of each term. The velocity needs the seconds once, the acceleration twice.
namespace forgot_h {

double position_before(double x, double v, double a, double h) {
    return x - v + a / 2;
}

}  // namespace forgot_h

// Says: This is how far the point goes in the step before, not where it was.
// Hint: You have the way from before to now. The point is now at x: where did that way begin?
namespace displacement {

double position_before(double x, double v, double a, double h) {
    return h * v - h * h / 2 * a;
}

}  // namespace displacement

// Says: The acceleration is multiplied by the step once, which makes it a velocity, not a way.
// Hint: Metres per second squared times seconds are metres per second. One factor is missing.
namespace one_h {

double position_before(double x, double v, double a, double h) {
    return x - h * v + h / 2 * a;
}

}  // namespace one_h

// Says: Both terms have the wrong sign: this is the mirror image of the way back.
// Hint: Expand x(t - h) by powers of h. Which of them change their sign with h, and which do not?
namespace both_reversed {

double position_before(double x, double v, double a, double h) {
    return x + h * v - h * h / 2 * a;
}

}  // namespace both_reversed

// Says: The force has the wrong sign and twice its size, as if you went back with the velocity that the point will
//       have a step later.
// Hint: On the way to now the velocity was still on its way to v. Was it larger than v where the force pushes
//       along it, or smaller?
namespace velocity_after {

double position_before(double x, double v, double a, double h) {
    return x - h * (v + h * a);
}

}  // namespace velocity_after

// Says: The velocity is not used: this is right at the top of a throw only.
// Hint: Throw the point without a force. Where was it a step ago?
namespace no_velocity {

double position_before(double x, double v, double a, double h) {
    return x + h * h / 2 * a;
}

}  // namespace no_velocity

// Says: A short step is taken for none: there you return the position of now.
// Hint: Nothing here divides by the step. In a film of molecules it is a millionth of a millionth of a second.
namespace short_step_is_none {

double position_before(double x, double v, double a, double h) {
    if (h < 1e-6) return x;
    return x - h * v + h * h / 2 * a;
}

}  // namespace short_step_is_none

// Says: This is the position half a step ago.
// Hint: Leapfrog keeps velocities half a step off. Verlet wants the position a whole step ago.
namespace half_a_step_back {

double position_before(double x, double v, double a, double h) {
    return x - h / 2 * v + h * h / 8 * a;
}

}  // namespace half_a_step_back
