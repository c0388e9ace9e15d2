#include "exercise.hpp"

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    const double kept = std::exp(-gamma * h);
    return now + kept * (now - before) + (1 - kept) * h * a / gamma;
}
