#include "exercise.hpp"

// Says: Three equal steps are leapfrog with a third of the step: the errors are smaller, but all have the
//       same sign, and the order is two still.
// Hint: Errors can cancel only if one of them is negative. What does that ask of q?
namespace equal_thirds {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1.0 / 3, q = p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace equal_thirds

// Says: The steps add up to h, but p comes from a square root of two: the third powers do not cancel.
// Hint: The error of a step goes with its third power. Solve 2p³ = -q³ for q.
namespace square_root {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::sqrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace square_root

// Says: The cube root has the wrong sign: all three steps go forward, and their errors add up.
// Hint: Put your p and q into 2p³ + q³. Is it zero?
namespace never_back {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 + std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace never_back

// Says: The step in the middle has the right length but goes forward: together the three go on by more than
//       four h.
// Hint: The sum of the three parts must be h. Without a force, how far does your ball get?
namespace back_step_forward {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = std::cbrt(2.0) * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace back_step_forward

// Says: p and q have changed places: two steps back and one forward go back, all in all.
// Hint: The step back stands once, in the middle.
namespace swapped {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {q * h, p * h, q * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace swapped

// Says: The right parts in the wrong order: the step back comes last. Such a step does not run back the way
//       it came, and its order is three.
// Hint: Read the three parts from the end. A method that runs back must read the same in both directions.
namespace long_first {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, p * h, q * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace long_first

// Says: The parts are right, but each is a step of semi-implicit Euler: its error begins with h², which
//       these parts do not cancel.
// Hint: The trick asks for a step whose error changes its sign when it goes back. Leapfrog has two half
//       kicks, one on either side of the drift.
namespace euler_inside {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part * omega * omega * std::sin(s.x);
        s.x += part * s.v;
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace euler_inside

// Says: The parts are right, but each takes one force for all of its length: "Newton", not leapfrog.
// Hint: The second half of the kick comes after the drift. Where must its force be taken?
namespace old_force {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        const double a = -omega * omega * std::sin(s.x);
        s.x += part * s.v + part * part / 2 * a;
        s.v += part * a;
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace old_force

// Says: The force is that of small oscillations, with the angle in the place of its sine.
// Hint: A wrecking ball swings wide, and an angle of 2 pi is the same place as 0.
namespace small_swings {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * s.x;
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * s.x;
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace small_swings

// Says: This is the classical Runge-Kutta method: of order four, but it does not run back the way it came,
//       and its swings slowly change.
// Hint: Asked are three steps of leapfrog. Order four is only half of what this exercise is after.
namespace runge_kutta {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const auto a = [&](double x) { return -omega * omega * std::sin(x); };
    const double v1 = s.v, a1 = a(s.x);
    const double v2 = s.v + h / 2 * a1, a2 = a(s.x + h / 2 * v1);
    const double v3 = s.v + h / 2 * a2, a3 = a(s.x + h / 2 * v2);
    const double v4 = s.v + h * a3, a4 = a(s.x + h * v3);
    return {s.t + h, s.x + h / 6 * (v1 + 2 * v2 + 2 * v3 + v4),
            s.v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
}

}  // namespace runge_kutta

// Says: This comes to one step of leapfrog, with h itself, of order two. If you wrote three, is there a 1 / 3? In
//       C++ that is 0, and p is then 1: write 1.0 / 3.
// Hint: Make a loop over three parts of h, and print p and q. Which parts make the third powers cancel?
namespace plain_leapfrog {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    s.v -= h / 2 * omega * omega * std::sin(s.x);
    s.x += h * s.v;
    s.v -= h / 2 * omega * omega * std::sin(s.x);
    return {s.t + h, s.x, s.v};
}

}  // namespace plain_leapfrog

// Says: p is right, but q is what is left of h after one part p. There are two of them, so the three steps
//       together go on by more than h.
// Hint: Add up p, q and p. The sum must be one.
namespace p_counted_once {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace p_counted_once

// Says: The angle is turned from degrees into radians, but it is in radians already.
// Hint: std::sin takes radians. In which unit does the task give the angle?
namespace degrees {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    const double degree = std::numbers::pi / 180;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(degree * s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(degree * s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace degrees

// Says: The force is omega times the sine: omega is not squared.
// Hint: Look at the units: an acceleration is in rad/s², and omega in rad/s.
namespace omega_not_squared {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace omega_not_squared

// Says: The force has the wrong sign: it drives the ball away from where it hangs.
// Hint: The acceleration is minus omega² sin x. Let a ball begin to the right of where it hangs: which way
//       does it start?
namespace pushes_away {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v += part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v += part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace pushes_away

// Says: The force has the cosine of the angle: a ball that hangs straight down would be driven away.
// Hint: Where the ball hangs at rest there is no force. Which of sine and cosine is zero there?
namespace cosine {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::cos(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::cos(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace cosine

// Says: Both kicks of a leap have its whole length, so that the force counts twice.
// Hint: Leapfrog kicks by half a step, drifts by a whole one, and kicks by half a step. How much force is
//       that together?
namespace whole_kicks {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part * omega * omega * std::sin(s.x);
    }
    return {s.t + h, s.x, s.v};
}

}  // namespace whole_kicks
