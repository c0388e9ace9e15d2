// Chapter 4, exercise 2: a bounce without a velocity
//
// Plain Verlet has moved a ball through the floor. There is no velocity to turn round: you have
// its two heights, and may change both. Move them as if it had fallen at the constant velocity
// that the two heights tell, had hit the floor somewhere on its way, and had risen for the rest
// of the step with $e$ times the speed. The two new heights must tell that new velocity to the
// next step.
//
//   before    height one step ago, in metres; above the floor or on it, never below
//   now       height now, in metres
//   floor     height of the floor, in metres; any number, also below zero
//   e         restitution: speed after the bounce over the speed before it, from 0 (it does not
//             bounce) to 1 (it loses nothing)
//   returns   `{before, now}`, the new heights; those given, if the ball is not below the floor
//             now
//
// Example: from 3 to -1 through a floor at 0 is 4 a step, and the last quarter of the way is too
// deep. With $e = 0.5$ the ball rises by 2 a step, for a quarter of a step, to 0.5. So
// `bounce_without_velocity(3, -1, 0, 0.5)` is `{-1.5, 0.5}`. That "before" lies below the floor
// is right.
//
// What is checked: a ball that is not below the floor is left alone; a ball ends where a
// slow-motion film of the bounce shows it; it leaves with the right speed; restitutions 0 and 1;
// balls that lay on the floor, and balls just below it; floors at any height.

#include "exercise.hpp"

std::array<double, 2> bounce_without_velocity(double before, double now, double floor, double e) {
    return not_started;  // your answer
}
