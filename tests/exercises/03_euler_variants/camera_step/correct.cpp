#include "exercise.hpp"

namespace backwards {

// Explicit Euler with −h leads from the new state to the old one: a matrix, inverted by Cramer.
State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    // (1) d − h v = d₁   (2) hω² d + (1 + 2ζωh) v = v₁   with d = x − target
    const double d1 = state.x - target;
    const double spring = h * omega * omega, damper = 1 + 2 * zeta * omega * h;
    const double determinant = damper + h * spring;
    const double d2 = (damper * d1 + h * state.v) / determinant;
    state.v = (state.v - spring * d1) / determinant;
    state.x = target + d2;
    state.t += h;
    return state;
}

}  // namespace backwards

namespace change {

// The change of the velocity, from the acceleration that the old velocity would lead to.
State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const double ahead = state.x + h * state.v;
    const double stiffness = omega * omega, damping = 2 * zeta * omega;
    const double acceleration = stiffness * (target - ahead) - damping * state.v;
    const double change = h * acceleration / (1 + h * damping + h * h * stiffness);
    return {state.t + h, ahead + h * change, state.v + change};
}

}  // namespace change

namespace way_over_time {

// The place first: one fraction. The velocity is what it has moved by, over h.
State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    if (h == 0) return state;
    const double a = omega * omega * h * h, b = 2 * zeta * omega * h;
    const double x2 = (state.x + b * state.x + h * state.v + a * target) / (1 + a + b);
    return {state.t + h, x2, (x2 - state.x) / h};
}

}  // namespace way_over_time
