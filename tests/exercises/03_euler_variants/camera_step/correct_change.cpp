#include "exercise.hpp"

// The change of the velocity, from the acceleration that the old velocity would lead to.
State<double> camera_step(State<double> state, double target, double omega, double zeta, double h) {
    const double ahead = state.x + h * state.v;
    const double stiffness = omega * omega, damping = 2 * zeta * omega;
    const double acceleration = stiffness * (target - ahead) - damping * state.v;
    const double change = h * acceleration / (1 + h * damping + h * h * stiffness);
    return {state.t + h, ahead + h * change, state.v + change};
}
