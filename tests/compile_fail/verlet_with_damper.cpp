// A damper needs a velocity, and plain Verlet keeps none.
// error: timestep: Verlet has no velocity to hand to a force: it needs acceleration() or acceleration(x)
#include <timestep/methods/verlet.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

int main() {
    const timestep::State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    const timestep::DampedSpring model(2.0, 0.1);
#else
    const timestep::Spring model(2.0);
#endif
    timestep::run(timestep::verlet, model, start, 0.1, 10);
}
