// A damper needs a velocity, and Verlet has none: this file must not compile.
#include <timestep/methods/verlet.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/run.hpp>

int main() {
    /// [damper]
    const timestep::DampedSpring damper(10.0, 0.1);  // ω and ζ
    const timestep::State start{0, 1.0, 0.0};
    timestep::run(timestep::verlet, damper, start, 0.01, 100);
    /// [damper]
}
