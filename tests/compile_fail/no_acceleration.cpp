// A model must say what its force is.
// error: timestep: a model needs a const member acceleration(), acceleration(x) or acceleration(x, v)
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/run.hpp>

struct Ball {
#ifdef MISUSE
    double gravity() const { return -9.81; }
#else
    double acceleration() const { return -9.81; }
#endif
};

int main() {
    timestep::run(timestep::explicit_euler, Ball{}, timestep::State{0.0, 1.0, 0.0}, 0.1, 10);
}
