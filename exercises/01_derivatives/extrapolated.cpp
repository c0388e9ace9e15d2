// Chapter 1, exercise 4: two results make a better one
//
// A tool bakes velocities into an animation. It computed each one twice, with a coarse step and
// with a finer one, by a formula whose order you know. So the error of each result is nearly $C$
// times its step to the power of the order, with the same unknown $C$. Combine the two so that
// these errors cancel.
//
//   coarse       the result with the larger step
//   fine         the result with the smaller step
//   ratio        the larger step divided by the smaller one (above 1, if only by a thousandth; not
//                always 2)
//   order        the order of the formula that gave both (1, 2, 3, …)
//   returns      the combination of the two in which the leading errors cancel
//
// Example: `extrapolated(1.4, 1.1, 2, 2)` is 1: the errors were 0.4 and a quarter of that. And
// `extrapolated(1.6, 1.2, 3, 1)` is 1, for errors of 0.6 and a third of that.
//
// What is checked: two equal results are left as they are; an error that is exactly $C$ times a
// power of the step vanishes, for any ratio; shifting or scaling both results does the same to
// the answer; a forward difference gains one order, a central one gains two.

#include "exercise.hpp"

double extrapolated(double coarse, double fine, double ratio, int order) {
    return not_started;  // your answer
}
