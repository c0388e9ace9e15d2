// Chapter 6, exercise 3: how long may a step of three looks be?
//
// An engine steps with a method by Kutta that looks at the rates three times:
//
//     k₁ = f(y₁)
//     k₂ = f(y₁ + h/2 k₁)
//     k₃ = f(y₁ + h (2 k₂ − k₁))
//     y₂ = y₁ + h/6 (k₁ + 4 k₂ + k₃)
//
// You put a door closer into it, a spring with a damper: $a = −ω² x − 2 ζ ω v$. The chapter's map
// has no line for this method. How long may the step be?
//
//   omega    angular frequency of the spring, rad/s (1e-6 to 1e6)
//   zeta     damping ratio, no unit (zero, or 1e-4 to 1e4)
//   returns  the longest step $h$, in seconds, up to which no run grows, whatever its start. Four
//            parts in 10⁸ off is near enough
//
// Example: `longest_kutta_step(10, 0.25)` is 0.24393 s, and `longest_kutta_step(10, 4)` is
// 0.031916 s.
//
// What is checked: with the step that you give, and with shorter ones, neither of the door's two
// decays grows, and with a step a little longer one does; runs of the door itself, below the
// limit and above; no damper, weak ones, critical damping and strong ones; only $ω h$ counts.

#include "exercise.hpp"

double longest_kutta_step(double omega, double zeta) {
    // [answer]
    // lambda / omega of the faster decay; where the door swings, the other one is its mirror image.
    const std::complex<double> fast = -zeta - std::sqrt(std::complex<double>(zeta * zeta - 1));
    const auto stable = [&](double wh) {
        const std::complex<double> z = wh * fast;
        return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0))) <= 1;
    };
    double good = 0, bad = 3;  // every spring has left the region at omega h = 3
    for (int i = 0; i < 80; ++i) {
        const double middle = (good + bad) / 2;
        (stable(middle) ? good : bad) = middle;
    }
    return good / omega;
    // [answer]
}
