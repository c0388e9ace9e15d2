// Chapter 4: stepping from two positions, without a velocity.

#include "sections.hpp"

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("verlet", "two positions instead of a velocity; and a rope made of them");
    program.option("--omega", settings.omega, lab::above_zero, "angular frequency, rad/s");
    program.option("--step", settings.step, lab::above_zero, "time step, s");
    program.option("--steps", settings.steps, 2, 100000, "number of steps in the first picture");
    program.option("--sweeps", settings.sweeps, 1, 1000, "Gauss-Seidel iterations over the rope's links a step");
    return program.run(argc, argv, [&](lab::Findings& out) {
        const timestep::Spring spring(settings.omega);  // refuses an ω whose square is not finite
        if (!(settings.wh() >= 1e-3 && settings.wh() <= 1e3))
            timestep::refuse("omega * step", settings.wh(), "from 0.001 to 1000 here");
        two_positions(settings, out);
        constant_force(settings, out);
        three_forms(settings, out);
        changing_steps(settings, out);
        demos(settings, out);
        ropes(settings, out);
        compliant_ropes(settings, out);
        costs(settings, out);
    });
}
