// Chapter 2, exercise 2: a car that sinks as the designer says
//
// Your designer wants a car that sinks by a given sag when it is put on its wheels, and that bobs
// with a given damping ratio. Work out the spring and the damper of one wheel. All four wheels are
// alike, they share the weight evenly, and the car moves only up and down, as one mass on four
// springs and four dampers side by side.
//
//   mass      of the car, above zero, in kg
//   sag       by which the springs give way under the car at rest, above zero, in m
//   zeta      damping ratio of the whole car, zero or more, without unit
//   g         acceleration of gravity, above zero, in m/s²
//   returns   stiffness $k$ in N/m and damping $c$ in N·s/m of one wheel, in this order
//
// Example: 1000 kg, a sag of 0.1 m, $ζ = 0.3$ and $g = 10$ give $k = 25000$ and $c = 1500$.
//
// What is checked: the four springs carry the weight; no damper for $ζ = 0$; the four dampers are
// critical at $ζ = 1$; the oscillation decays as $ζ$ says, below 1 and above; twice the car needs
// twice the spring and twice the damper; another planet.

#include "exercise.hpp"

std::array<double, 2> suspension(double mass, double sag, double zeta, double g) {
    return not_started;  // your answer
}
