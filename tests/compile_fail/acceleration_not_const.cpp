// A method reads the model and does not change it, so the force must be a const member.
// error: timestep: a model needs a const member acceleration(), acceleration(x) or acceleration(x, v)
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/run.hpp>

struct Spring {
#ifdef MISUSE
    double acceleration(double x) { return -x; }
#else
    double acceleration(double x) const { return -x; }
#endif
};

int main() {
    timestep::run(timestep::runge_kutta_4, Spring{}, timestep::State{0.0, 1.0, 0.0}, 0.1, 10);
}
