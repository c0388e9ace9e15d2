// Chapter 3: one spring, three Eulers.

#include <cmath>
#include <cstdio>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "lab.hpp"

using namespace timestep;

namespace {

struct Settings {
    double omega = 10;       // rad/s
    double step = 1.0 / 60;  // s
    long steps = 120;
};

template <class Method>
void portrait(const Method& method, const char* id, const Settings& settings, lab::Findings& out) {
    const Spring spring(settings.omega);
    const State start{0, 1.0, 0.0};
    auto& table = out.table(std::string(id) + ".tsv", {"t", "x", "v_over_omega"});
    const State end = run(method, spring, start, settings.step, settings.steps, [&](const auto& s) {
        table.row({s.t, s.x, s.v / settings.omega});
    });
    const double amplitude = std::hypot(end.x, end.v / settings.omega);
    std::printf("  %-20s amplitude %8.4f m after %g s\n", Method::name, amplitude, end.t);
    out.number(std::string(id) + "_amplitude", amplitude, "m", "amplitude at the end of the run");
}

}  // namespace

int main(int argc, char** argv) {
    Settings settings;
    lab::Program program("euler_variants", "three Eulers step one spring");
    program.option("--omega", settings.omega, lab::above_zero, "angular frequency, rad/s");
    program.option("--step", settings.step, lab::above_zero, "time step, s");
    program.option("--steps", settings.steps, 1, 1000000, "number of steps");
    return program.run(argc, argv, [&](lab::Findings& out) {
        out.section("Three Eulers on one spring");
        portrait(explicit_euler, "explicit_euler", settings, out);
        portrait(implicit_euler, "implicit_euler", settings, out);
        portrait(semi_implicit_euler, "semi_implicit_euler", settings, out);
    });
}
