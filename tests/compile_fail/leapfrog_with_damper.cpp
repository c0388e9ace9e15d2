// A damper needs a velocity, and leapfrog has none yet where it asks for the force.
// error: timestep: Verlet has no velocity to hand to a force: it needs acceleration() or acceleration(x)
#include <timestep/methods/leapfrog.hpp>
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
    timestep::run(timestep::leapfrog, model, start, 0.1, 10);
}
