// Chapter 6, exercise 5: a chain that cannot blow up
//
// An anchor chain hangs from a ship that lies still: some masses in a row, a stiff link between
// each and the next, and one from the first mass to the ship. $x$ is how far a mass is from its
// place at rest. A link pulls its two ends together with $k$ times what it is too long, so that
// the force on a mass is
//
//     k (x_{above} − x) + k (x_{below} − x)
//
// For the first mass x_above is zero. The last mass has nothing below it: its second term is
// missing. (The weight is in the places at rest.) With explicit steps you would need thousands a
// frame. Take one of implicit Euler:
//
//     m (v₂ − v₁) = h (\text{force with all }x₂) \quad x₂ = x₁ + h v₂
//
// That is one equation for each mass, and its neighbours are in it. You need no matrix: with three
// unknowns an equation, a chain of a hundred thousand links is solved in milliseconds. (The tests'
// chains have 60 masses at most, so that you can read them.)
//
//   s        the masses, from the top: time `s[i].t` in s, the same for all, $x$ in m, $v$ in
//            m/s; at least one
//   m        of each, kg (above zero)
//   k        stiffness of each link, N/m (zero or more)
//   h        length of the step, s (zero or more; $h² k / m$ is at most 1e6)
//   returns  the masses a time $h$ later, right to nine digits
//
// Example: `chain_step({{0, 0, 0}, {0, 1, 0}}, 1, 100, 0.1)` is
// `{{0.1, 0.2, 2}, {0.1, 0.6, -4}}`.
//
// What is checked: in no time nothing happens, and free masses fly on; a mass alone is a spring; at
// the end of the step each mass obeys the equations above; the momentum that comes from the ship;
// patterns in which a chain swings; no step adds energy; a very stiff chain is in its place after a
// step.

#include "exercise.hpp"

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    return not_started;  // your answer
}
