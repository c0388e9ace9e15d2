// Chapter 6, exercise 2: a slider between two Eulers
//
// Your engine has a slider for its integrator. At 0 it is explicit Euler, at 1 implicit Euler, and
// in between it mixes the rates at both ends of the step:
//
//     y₂ = y₁ + h ((1 − θ) f(y₁) + θ f(y₂))
//
// Beside the slider you want to show what a step does to the fastest motion of the scene. That is
// a decay $f(y) = λ y$ with a complex rate $λ$. A step multiplies $y$ by $R(h λ)$; how large is
// this factor? Above 1 the motion grows, below 1 it dies.
//
//   re, im   $λ = re + i im$, both in 1/s, of any sign or zero; $|h λ|$ is at most 1e6
//   theta    the slider, 0 to 1
//   h        length of the step, s (zero or more)
//   returns  $|R|$, the size of $y₂$ over the size of $y₁$, with all its digits: an error of one
//            part in 10⁹ is too much
//
// Where $θ h λ$ is 1, a step has no answer. The numbers that are drawn keep away from that.
//
// Example: for $λ = −3 + 4i$, $θ = 0.25$ and $h = 0.5$ the factor is 1.0288: the motion grows,
// though the true one dies.
//
// What is checked: a step of zero; a pure decay obeys the method's equation; the two Eulers at
// the ends of the slider; $θ = 1/2$ keeps an oscillation without damping; where a motion grows
// and where it dies, and the circle in between; for short steps it is what the true motion
// multiplies by, and how fast it gets there; far out; $λ$ and its mirror image below the real
// axis.

#include "exercise.hpp"

double amplification(double re, double im, double theta, double h) {
    // [answer]
    // y2 - theta z y2 = y1 + (1 - theta) z y1
    const std::complex<double> z(h * re, h * im);
    return std::abs((1.0 + (1 - theta) * z) / (1.0 - theta * z));
    // [answer]
}
