// Chapter 4, exercise 6: three leaps for order four
//
// A wrecking ball must hit exactly, and swing for an hour without gaining or losing height.
// Leapfrog keeps its height but has order two only. Its step of $h$ is wrong by $C h³$ in the
// first place, where $C$ depends on the motion but not on $h$; a step back, of $−h$, is wrong by
// $−C h³$. So take three steps of leapfrog in one: of $p h$, of $q h$ and of $p h$ again, with
// two numbers $p$ and $q$ such that together they go on by $h$, and the errors with the third
// powers cancel. Then order four is left. Compute $p$ and $q$, as numbers rounded to a few digits
// bring a little of order two back. (Any other method of order four, not more, will do that has
// all the properties below.)
//
//   s         state now: `s.t` in seconds, the angle `s.x` in radians from hanging straight down
//             (it may be large: a ball can go round), its rate of change `s.v` in radians per
//             second
//   omega     of small oscillations, in rad/s: the acceleration is $x'' = −ω² \sin x$. Zero or
//             more
//   h         the step, in seconds; may be negative, which runs time backwards. The size of $ω$
//             times $h$ is at most 1
//   returns   the state $h$ later, its time as well
//
// Example: `fourth_order_leapfrog({0, 1, 0}, 1, 0.5)` is `{0.5, 0.89651, -0.41097}`. Exact are
// 0.89603 and -0.41088; one step of leapfrog ends at 0.89482 and -0.40539.
//
// What is checked: a step goes on in time by $h$; without a force the rate stays; a ball that
// hangs still stays; runs end where the pendulum ends, with an error of order four, in short
// steps and in long ones; a step forth and a step back leave the state as it was; neighbouring
// states together cover as much area after a step as before it, so that swings neither grow nor
// die.

#include "exercise.hpp"

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    // [answer]
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;  // 2p + q = 1, 2p³ + q³ = 0
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
    // [answer]
}
