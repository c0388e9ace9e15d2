// Chapter NEW_NUMBER: the numbers that its page names, and the checks of its sentences.

#include <cmath>

#include <lab.hpp>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/models/projectile.hpp>

using namespace timestep;

namespace {

const double gravity = -9.81;  // m/s²

// The error of explicit Euler after one second of `steps` steps, m.
double error_of(long steps) {
    const Projectile ball(gravity);
    const State start{0, 0.0, 0.0};
    State state = start;
    for (long n = 0; n < steps; ++n) state = explicit_euler.step(ball, state, 1.0 / steps);
    return state.x - ball.exact(start, 1).x;
}

}  // namespace

// FILL IN: what you measure. `out.table` writes data for study/figures.gp; about.json then lists all "figures".
int main(int argc, char** argv) {
    long steps = 10;
    lab::Program program("NEW_NAME", "the error of explicit Euler on a falling ball");
    program.option("--steps", steps, 1, 1000, "steps per second");
    return program.run(argc, argv, [&](lab::Findings& out) {
        const double error = error_of(steps);
        out.section("One second of falling");
        out.number("steps", static_cast<double>(steps), "", "steps in the second");
        out.number("error", error, "m", "explicit Euler is too high by this after one second");
        // The positions are below 5 m: 2000 roundings of 5e-16 m each.
        out.check("half_the_error", std::fabs(error_of(2 * steps) - error / 2) < 1e-12,
                  "halving the step halves the error");
    });
}
