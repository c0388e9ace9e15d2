// Damping at the new velocity is one division where the force is linear in the velocity, and only there.
// error: timestep: damping at the new velocity needs a force that is linear in the velocity, with slope_v()
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/run.hpp>

struct Drag {
#ifdef MISUSE
    double acceleration(double, double v) const { return -v * v; }
    double slope_x(double, double) const { return 0; }
    double slope_v(double, double v) const { return -2 * v; }
#else
    double acceleration(double, double v) const { return -v; }
    double slope_x() const { return 0; }
    double slope_v() const { return -1; }
#endif
};

int main() {
    const timestep::State start{0.0, 1.0, 0.0};
    timestep::run(timestep::semi_implicit_euler_new_damping, Drag{}, start, 0.1, 10);
}
