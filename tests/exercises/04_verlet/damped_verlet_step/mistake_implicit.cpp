#include "exercise.hpp"

double damped_verlet_step(double before, double now, double a, double gamma, double h) {
    return now + (now - before + h * h * a) / (1 + gamma * h);
}
