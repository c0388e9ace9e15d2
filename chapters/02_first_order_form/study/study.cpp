// Chapter 2: differential equations, the form in which solvers take them, and the loop around them.

#include "sections.hpp"

namespace {

// The pictures show four seconds or so: steps and swings must fit into them, and a shell whose long
// fall ends more slowly would be stopped by the air within the coarsest steps.
bool between(double value, double least, double most) { return value >= least && value <= most; }
const lab::Rule masses{[](double m) { return between(m, 0.01, 1e6); }, "from 0.01 to 1e6"};
const lab::Rule stiffnesses{[](double k) { return between(k, 0.01, 1e9); }, "from 0.01 to 1e9"};
const lab::Rule dampings{[](double c) { return between(c, 0, 1e9); }, "from 0 to 1e9"};
const lab::Rule speeds{[](double v) { return between(v, 5, 1e6); }, "from 5 to 1e6"};
const lab::Rule steps{[](double h) { return between(h, 1e-4, 0.25); }, "from 0.0001 to 0.25"};

void within(const char* name, double value, double least, double most) {
    char rule[80];
    std::snprintf(rule, sizeof rule, "between %g and %g here", least, most);
    if (!(value >= least && value <= most)) timestep::refuse(name, value, rule);
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("first_order_form", "springs, shells and characters in one solver, one loop");
    program.option("--mass", settings.mass, masses, "the character's mass, kg");
    program.option("--stiffness", settings.stiffness, stiffnesses, "of its legs, N/m");
    program.option("--damping", settings.damping, dampings, "of its legs, N s/m");
    program.option("--terminal-speed", settings.terminal_speed, speeds, "of the grenade in a long fall, m/s");
    program.option("--step", settings.step, steps, "the game loop's fixed step, s");
    program.option("--method", settings.method, {"explicit_euler", "semi_implicit_euler", "runge_kutta_4"},
                   "the solver in the game loop");
    return program.run(argc, argv, [&](lab::Findings& out) {
        within("omega = sqrt(stiffness / mass)", settings.omega(), 0.5, 100);
        within("zeta = damping / (2 sqrt(stiffness mass))", settings.zeta(), 0, 20);
        solutions(settings, out);
        portrait(settings, out);
        damping(settings, out);
        arrays(settings, out);
        hard_problems(settings, out);
        game_loop(settings, out);
        break_it(settings, out);
        other_bits(settings, out);
    });
}
