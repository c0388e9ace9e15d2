// The same for a first-order system.
// error: timestep: implicit methods need the system's derivative slope_y(t, y)
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/run.hpp>

struct Decay {
    double operator()(double, double y) const { return -y; }
#ifndef MISUSE
    double slope_y(double, double) const { return -1; }
#endif
};

int main() {
    timestep::run(timestep::implicit_euler, Decay{}, timestep::FirstOrder{0.0, 1.0}, 0.1, 10);
}
