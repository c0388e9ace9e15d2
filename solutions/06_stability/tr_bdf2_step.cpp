// Chapter 6, exercise 6: neither ringing nor fading
//
// A turret is held by a spring with a damper, and the designers make it stiffer with every build.
// Implicit midpoint rings, implicit Euler swallows the slow oscillations, and BDF2 needs a step
// before it. So combine them, within one step of $h$. First a part of $γ h$ with the trapezoid
// rule, to a state ym between:
//
//     ym = y₁ + γ h/2 (f(y₁) + f(ym)) \quad γ = 2 − \sqrt{2}
//
// Then the idea of BDF2, with steps that differ: the parabola through $y₁$ at 0, ym at $γ h$ and
// $y₂$ at $h$ has the slope $f(y₂)$ at its end. You have to find out what that makes of $y₂$. $y$
// is `{x, v}` and $f(y)$ is `{v, -omega² x - 2 zeta omega v}`.
//
//   s        the turret now: time `s.t` in s, `s.x` in m from where the spring is relaxed, `s.v`
//            in m/s
//   omega    angular frequency of the spring, rad/s (zero, or 1e-3 to 1e6)
//   zeta     damping ratio, no unit (zero or more)
//   h        length of the step, in s (zero or more; $ω h$ and $ζ ω h$ are at most 1e6)
//   returns  the state a time $h$ later, with all its digits: rounded weights will not do
//
// Example: `tr_bdf2_step({0, 1, 0}, 10, 0.25, 0.1)` is `{0.1, 0.63761, -6.6344}`. Exact are
// 0.60705 and -6.6269.
//
// What is checked: the clock, and a step of zero; a turret without a spring flies on; each of the
// two decays that a spring is made of is multiplied by this method's $R(z)$, weak dampers and
// strong ones; runs end where the true motion ends, with an error of order two; no step adds
// energy; how little of a slow oscillation is lost; a stiff spring is at rest after one step, and
// a hard damper does not ring.

#include "exercise.hpp"

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    // [answer]
    const double gamma = 2 - std::sqrt(2.0), part = gamma * h / 2;
    const auto acceleration = -omega * omega * s.x - 2 * zeta * omega * s.v;
    // The y with y - part f(y) = (x, v): for this gamma both halves have the same part.
    const auto solve = [&](double x, double v) {
        const double wp = omega * part;
        const double v2 = (v - wp * omega * x) / (1 + 2 * zeta * wp + wp * wp);
        return std::array{x + part * v2, v2};
    };
    const auto [xm, vm] = solve(s.x + part * s.v, s.v + part * acceleration);
    // (2 - gamma)/(1 - gamma) (y2 - y1) - (ym - y1)/(gamma (1 - gamma)) = h f(y2)
    const double w = 1 / (gamma * (2 - gamma));
    const auto [x2, v2] = solve(s.x + w * (xm - s.x), s.v + w * (vm - s.v));
    return {s.t + h, x2, v2};
    // [answer]
}
