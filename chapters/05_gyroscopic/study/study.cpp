// Chapter 5: bodies that tumble, and what games do about the gyroscopic torque.

#include "sections.hpp"

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("gyroscopic", "bodies spin and tumble; which solver tells the truth?");
    const lab::Rule step{[](double h) { return h >= 0.004 && h <= 0.1; }, "from 0.004 to 0.1"};
    const lab::Rule spin{[](double w) { return w >= 1 && w <= 100; }, "from 1 to 100"};
    const lab::Rule tilt{[](double w) { return w > 0 && w <= 1; }, "above zero and at most 1"};
    program.option("--step", settings.step, step, "time step, s");
    program.option("--spin", settings.spin, spin, "spin of the box about its intermediate axis, rad/s");
    program.option("--tilt", settings.tilt, tilt, "its spin about the other two, rad/s");
    return program.run(argc, argv, [&](lab::Findings& out) {
        torque(settings, out);
        orientation(settings, out);
        between_steps(settings, out);
        newton(settings, out);
        free_capsule(settings, out);
        uneven_capsule(settings, out);
        staff(settings, out);
        tumble(settings, out);
        minute(settings, out);
        energy_map(settings, out);
        capsule_on_plane(settings, out);
        driven_body(settings, out);
        films(settings, out);
    });
}
