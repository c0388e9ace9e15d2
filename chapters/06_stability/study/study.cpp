// Chapter 6: will my simulation blow up?

#include "sections.hpp"

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("stability", "stiff springs, hard damping, absurd numbers: what survives?");
    program.option("--omega", settings.omega, lab::above_zero, "angular frequency of your spring, rad/s");
    program.option("--zeta", settings.zeta, lab::zero_or_more, "its damping ratio");
    program.option("--step", settings.step, lab::above_zero, "time step, s");
    return program.run(argc, argv, [&](lab::Findings& out) {
        your_spring(settings, out);
        definitions(settings, out);
        regions(settings, out);
        stiff_decay(settings, out);
        boundary(settings, out);
        stiff_springs(settings, out);
        two_scales(settings, out);
        kicks(settings, out);
        velocity_forces(settings, out);
        cures(settings, out);
        prothero_robinson(settings, out);
        reactions(settings, out);
        cloth(settings, out);
        extreme_inputs(settings, out);
        advice(settings, out);
        advice_bodies(settings, out);
        leave_out(settings, out);
    });
}
