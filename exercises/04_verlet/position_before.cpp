// Chapter 4, exercise 1: the position before the first
//
// Your rope code keeps two positions for every point, now and one step before. The player throws
// the end of the rope: you know where it is, how fast it is to fly and what force pulls at it.
// Which position must stand in the place of "before", so that Verlet throws it right from its first
// step on?
//
//   x         position now, in metres
//   v         velocity now, in metres per second
//   a         acceleration now, in metres per second squared
//   h         the step of Verlet, in seconds (greater than zero)
//   returns   the position one step before now, in metres
//
// Example: a stone at the top of its throw, $x = 5$, $v = 0$, $a = −10$. With $h = 0.2$, a $h²/2$
// is -0.2, and `position_before(5, 0, -10, 0.2)` is 4.8: the stone was lower, on its way up.
//
// What is checked: at rest and without a force the two positions are the same; with a constant
// acceleration the position lies on the parabola through now, and Verlet's next step too, in games
// of any size and with any step; a whole run of Verlet on a spring, started from it, has order two.

#include "exercise.hpp"

double position_before(double x, double v, double a, double h) {
    return not_started;  // your answer
}
