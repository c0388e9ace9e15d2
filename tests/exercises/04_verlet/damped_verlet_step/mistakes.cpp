#include "exercise.hpp"

// Says: The displacement is shortened by gamma h, the drag at the velocity of the last step: two short steps keep
//       another part of it than a long one, and a strong drag turns the motion round.
// Hint: Compare two steps of h with one of 2h. Which function of h gives the same, multiplied by itself, as
//       for the double?
namespace straight_line {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + (1 - gamma * h) * (now - before) + h * h * a;
}

}  // namespace straight_line

// Says: The displacement is shortened right, but the force enters as if there were no drag within the step:
//       the terminal velocity depends on the step.
// Hint: Let a body fall at a / gamma. Its next displacement must be the same as the last one, exactly.
namespace undamped_force {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + std::exp(-gamma * h) * (now - before) + h * h * a;
}

}  // namespace undamped_force

// Says: The whole step of Verlet, its force too, is shortened by exp(-gamma h): as if all of the force had
//       come before the drag.
// Hint: The force acts all the time, its first part damped most and its last part hardly. Test with the
//       velocity at which the drag balances it.
namespace force_shortened_too {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + std::exp(-gamma * h) * (now - before + h * h * a);
}

}  // namespace force_shortened_too

// Says: Right for every drag but none: with gamma = 0 you divide zero by zero.
// Hint: A body without drag has no terminal velocity. What should the step be then?
namespace zero_drag {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace zero_drag

// Says: The displacement shrinks by exp(-gamma) in every step, whatever its length: twice the frames, twice
//       the drag.
// Hint: gamma is in 1/s. What is exponentiated must have no unit.
namespace per_step {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma);
    return now + kept * (now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace per_step

// Says: The exponent has the wrong sign: the drag drives the body.
// Hint: A velocity that nothing drives must get less: is your factor below one?
namespace grows {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(gamma * h);
    return now + kept * (now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace grows

// Says: Dividing by 1 + gamma h is implicit Euler's damping. It never turns a motion round, and gets the
//       terminal velocity right, but dies down by less at long steps.
// Hint: Stable is not yet exact. Of which function are 1 - gamma h and 1 / (1 + gamma h) two approximations?
namespace implicit {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + (now - before + h * h * a) / (1 + gamma * h);
}

}  // namespace implicit

// Says: The factor shrinks the position, not only the displacement: the point is drawn to the origin.
// Hint: The drag knows no places. Where the point is must enter with the weight one.
namespace position_shrinks {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h);
    return kept * (2 * now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace position_shrinks

// Says: This is Verlet with the drag taken at the central difference of the positions, as much rope code has
//       it: of order two and good for a weak drag, but a strong one turns the motion round.
// Hint: (1 - gamma h/2) / (1 + gamma h/2) is another approximation of a factor per step, negative beyond
//       gamma h = 2. Which function is approximated?
namespace central_drag {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    const double half = gamma * h / 2;
    return now + ((now - before) * (1 - half) + h * h * a) / (1 + half);
}

}  // namespace central_drag

// Says: The terminal velocity a / gamma is added to a position: the step is missing.
// Hint: a / gamma is in metres per second. How far does a body get with it in one step?
namespace forgot_h {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) + (1 - kept) * a / gamma;
}

}  // namespace forgot_h

// Says: The force pushes the wrong way: its term has the wrong sign, while the drag is right.
// Hint: Put a straight line x = C t into x'' = a - gamma x'. Which sign has C where a is positive?
namespace force_reversed {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) - (1 - kept) * h * a / gamma;
}

}  // namespace force_reversed

// Says: The displacement loses the part gamma in every step, as rope codes do it: the length of the step is
//       not used for the drag.
// Hint: gamma is the part lost in a second, as long as that is short. How much is lost in h seconds, and in
//       twice as many?
namespace gamma_per_step {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + (1 - gamma) * (now - before) + h * h * a;
}

}  // namespace gamma_per_step

// Says: Where there is drag the force is forgotten: a feather that is let go hangs in the air.
// Hint: Let it begin at rest: before and now are equal. What makes it fall in your formula?
namespace force_forgotten {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    return now + std::exp(-gamma * h) * (now - before);
}

}  // namespace force_forgotten

// Says: The velocity is the terminal one at once: what the body had of its own is forgotten.
// Hint: Without a force a thrown feather still flies on for a while. Which term has now - before in it?
namespace only_terminal {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    return now + h * a / gamma;
}

}  // namespace only_terminal

// Says: The new way is added to the position one step ago, so that the point lags behind.
// Hint: The displacement begins where the point is now. Which of the two positions is that?
namespace from_before {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h);
    return before + kept * (now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace from_before

// Says: The exponent has a half too many: the drag is that of half a step.
// Hint: From the middle of the last step to that of the next one, how much time goes by?
namespace half_the_exponent {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h / 2);
    return now + kept * (now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace half_the_exponent

// Says: The force gives its terminal velocity in full at once, beside what is left of the old one.
// Hint: Let a body fall at a / gamma already. Then the next displacement must be the last one: is yours
//       larger?
namespace terminal_added_in_full {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) + h * a / gamma;
}

}  // namespace terminal_added_in_full

// Says: The terminal velocity is a times gamma, so that a stronger drag makes a faster fall.
// Hint: At the terminal velocity drag and force are equal: gamma times v is a. What is v?
namespace times_gamma {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) + (1 - kept) * h * a * gamma;
}

}  // namespace times_gamma

// Says: In a step so long that the drag leaves nothing of the velocity, you let the body stay where it is. But the
//       force goes on acting.
// Hint: What is left is the velocity at which the drag balances the force. How far does that take the body in h?
namespace long_step_stays {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    if (gamma * h > 40) return now;
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) + (1 - kept) * h * a / gamma;
}

}  // namespace long_step_stays

// Says: The mean velocity of the last step is taken for the velocity now, at its end. By then drag and force
//       have changed it.
// Hint: now − before is what the exact path goes in a step. By what factor is the next such way shorter, if
//       nothing drives?
namespace mean_for_now {

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double time = -std::expm1(-gamma * h) / gamma;
    return now + time * (now - before) / h + (h - time) * a / gamma;
}

}  // namespace mean_for_now
