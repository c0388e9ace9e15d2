#include "exercise.hpp"

namespace expm1 {

// Verlet's step with a shorter displacement and a shorter time for the force, both without
// cancellation.
double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    const double lost = -std::expm1(-gamma * h);
    const double time = gamma > 0 ? lost / gamma : h;
    return now + (1 - lost) * (now - before) + h * time * a;
}

}  // namespace expm1

namespace terminal_frame {

// Who falls along at the terminal velocity sees no force: the displacement only shrinks.
double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma > 0) {
        const double along = h * a / gamma;
        return now + along + (now - before - along) / std::exp(gamma * h);
    }
    return now + (now - before) + a * h * h;
}

}  // namespace terminal_frame

namespace three_constants {

// The constants of the path through the two positions, with t = 0 now.
double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    if (gamma == 0) return 2 * now - before + h * h * a;
    const double C = a / gamma;
    const double B = (before - now + C * h) / std::expm1(gamma * h);
    return now + B * std::expm1(-gamma * h) + C * h;
}

}  // namespace three_constants
