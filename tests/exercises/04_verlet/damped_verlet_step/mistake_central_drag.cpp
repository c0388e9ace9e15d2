#include "exercise.hpp"

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    const double half = gamma * h / 2;
    return now + ((now - before) * (1 - half) + h * h * a) / (1 + half);
}
