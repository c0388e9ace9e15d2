#include "exercise.hpp"

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + std::exp(-gamma * h) * (now - before + h * h * a);
}
