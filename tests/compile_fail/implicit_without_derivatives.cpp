// An implicit method solves for the new state and needs the force's derivatives for that.
// error: timestep: implicit methods need the force's derivatives slope_x and slope_v
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/run.hpp>

struct Cubic {
    double acceleration(double x) const { return -x * x * x; }
#ifndef MISUSE
    double slope_x(double x, double) const { return -3 * x * x; }
    double slope_v(double, double) const { return 0; }
#endif
};

int main() {
    timestep::run(timestep::implicit_euler, Cubic{}, timestep::State{0.0, 1.0, 0.0}, 0.1, 10);
}
