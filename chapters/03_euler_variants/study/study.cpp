// Chapter 3: one spring, three Eulers, and the methods they are compared with.

#include "sections.hpp"

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("euler_variants", "three Eulers step one spring; which one stays?");
    program.option("--omega", settings.omega, lab::above_zero, "angular frequency, rad/s");
    program.option("--step", settings.step, lab::above_zero, "time step, s");
    program.option("--steps", settings.steps, 1, 100000, "number of steps in the portraits");
    program.option("--method", settings.method, {"all", "explicit_euler", "implicit_euler", "semi_implicit_euler"},
                   "the method in the portraits");
    return program.run(argc, argv, [&](lab::Findings& out) {
        const timestep::Spring spring(settings.omega);  // refuses an ω whose square is not finite
        // The pictures take 2π/ωh steps a swing, one row of data each.
        if (!(settings.wh() >= 1e-3 && settings.wh() <= 1e3))
            timestep::refuse("omega * step", settings.wh(), "from 0.001 to 1000 here");
        portraits(settings, out);
        energies(settings, out);
        eigenvalue_paths(settings, out);
        matrices(settings, out);
        areas(settings, out);
        sweep(settings, out);
        damping(settings, out);
        dampers(settings, out);
        soft_constraints(settings, out);
        orders(settings, out);
        bounces(settings, out);
        costs(settings, out);
    });
}
