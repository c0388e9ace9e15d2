// Chapter 2: differential equations, the form in which solvers take them, and the loop around them.

#include "sections.hpp"

namespace {

// The pictures show four seconds or so: steps and swings must fit into them.
void within(const char* name, double value, double least, double most) {
    char rule[80];
    std::snprintf(rule, sizeof rule, "between %g and %g here", least, most);
    if (!(value >= least && value <= most)) timestep::refuse(name, value, rule);
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("first_order_form",
                         "springs, shells and characters in one solver, one loop");
    program.option("--mass", settings.mass, lab::above_zero, "the character's mass, kg");
    program.option("--stiffness", settings.stiffness, lab::above_zero, "of its legs, N/m");
    program.option("--damping", settings.damping, lab::zero_or_more, "of its legs, N s/m");
    program.option("--terminal-speed", settings.terminal_speed, lab::above_zero,
                   "of the grenade in a long fall, m/s");
    program.option("--step", settings.step, lab::above_zero, "the game loop's fixed step, s");
    program.option("--method", settings.method,
                   {"explicit_euler", "semi_implicit_euler", "runge_kutta_4"},
                   "the solver in the game loop");
    return program.run(argc, argv, [&](lab::Findings& out) {
        within("step", settings.step, 1e-4, 0.25);
        within("omega = sqrt(stiffness / mass)", settings.omega(), 0.5, 100);
        within("zeta = damping / (2 sqrt(stiffness mass))", settings.zeta(), 0, 20);
        within("terminal speed", settings.terminal_speed, 1, 1e6);
        solutions(settings, out);
        portrait(settings, out);
        damping(settings, out);
        arrays(settings, out);
        hard_problems(settings, out);
        game_loop(settings, out);
        break_it(settings, out);
    });
}
