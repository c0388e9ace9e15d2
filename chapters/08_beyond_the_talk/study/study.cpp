// Chapter 8: what comes after the talk's solver, for one body and for many.

#include "sections.hpp"

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("beyond_the_talk", "better rigid bodies: what do they cost, which to take?");
    const lab::Rule step{[](double h) { return h >= 0.004 && h <= 0.1; }, "from 0.004 to 0.1"};
    const lab::Rule spin{[](double w) { return w >= 1 && w <= 100; }, "from 1 to 100"};
    const lab::Rule tilt{[](double w) { return w > 0 && w <= 1; }, "above zero and at most 1"};
    program.option("--step", settings.step, step, "time step of 'One token', 'A minute', s");
    program.option("--spin", settings.spin, spin, "spin of the box in 'One token', rad/s");
    program.option("--tilt", settings.tilt, tilt, "its spin about its other two axes, rad/s");
    return program.run(argc, argv, [&](lab::Findings& out) {
        one_token(settings, out);
        orders(settings, out);
        fails(settings, out);
        minute(settings, out);
        work(settings, out);
        throws(settings, out);
        contacts(settings, out);
        runge_kutta(settings, out);
        many(settings, out);
        demo(settings, out);
        engines(out);
    });
}
