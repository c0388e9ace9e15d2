// Plain Verlet, velocity Verlet and leapfrog: one method, three ways to write it; and the first
// step.

#include <algorithm>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

const State<double> start{0, 1.0, 0.5};

// Verlet whose first step leaves out the force, as it is often written.
struct CarelessStart : Verlet {
    template <class Model>
    State<double> start(const Model&, const State<double>& s, double h) const {
        return {s.t + h, s.x + h * s.v, s.v};
    }
};

// Verlet whose first position is that of semi-implicit Euler.
struct EulerStart : Verlet {
    template <class Model>
    State<double> start(const Model& model, const State<double>& s, double h) const {
        return semi_implicit_euler.step(model, s, h);
    }
};

template <class Method>
double start_order(const Method& method, const std::string& file, lab::Findings& out) {
    const Spring spring(1.0);
    auto& table = out.table(file, {"step", "error"});
    std::vector<double> h, error;
    for (int i = 0; i <= 14; ++i) {
        const long steps = std::lround(10 * std::pow(2.0, i / 2.0));
        const State end = run(method, spring, start, 2.0 / steps, steps);
        const double off = std::fabs(end.x - spring.exact(start, 2.0).x);
        table.row({2.0 / steps, off});
        if (i >= 4) h.push_back(2.0 / steps), error.push_back(off);
    }
    return measured_order(h, error);
}

}  // namespace

void three_forms(const Settings&, lab::Findings& out) {
    out.section("Three forms of one method");
    const Pendulum pendulum(1.0);
    const double h = 0.05;
    const long steps = 10000;
    std::vector<double> plain, with_velocity, velocity, leaping;
    run(verlet, pendulum, start, h, steps, [&](const auto& s) { plain.push_back(s.x); });
    run(velocity_verlet, pendulum, start, h, steps,
        [&](const auto& s) { with_velocity.push_back(s.x), velocity.push_back(s.v); });
    run(leapfrog, pendulum, start, h, steps, [&](const auto& s) { leaping.push_back(s.x); });
    double a = 0, b = 0, c = 0;
    for (long n = 1; n < steps; ++n) {
        const auto i = std::size_t(n);
        a = std::max(a, std::fabs(plain[i] - with_velocity[i]));
        b = std::max(b, std::fabs(leaping[i] - with_velocity[i]));
        c = std::max(c, std::fabs((plain[i + 1] - plain[i - 1]) / (2 * h) - velocity[i]));
    }
    std::printf(
        "  a pendulum, %ld steps: plain and velocity Verlet differ by %.1e rad,\n"
        "  leapfrog and velocity Verlet by %.1e rad\n",
        steps, a, b);
    out.number("forms_steps", double(steps), "", "steps of the three forms");
    out.number("forms_plain", a, "rad", "plain against velocity Verlet", 2);
    out.number("forms_leapfrog", b, "rad", "leapfrog against velocity Verlet", 2);
    // An error δ of the phase of a pendulum grows like n, since its period depends on its swing:
    // δ/sin θ in the amplitude changes θ by at most as much, in each of the steps that follow: n²/2
    // δ in all, here with δ = 4ε.
    const double bound = 4 * eps / h * double(steps) * (1 + steps * h / 2);
    out.check("forms_agree", a < bound && b < bound && c < bound / h,
              "plain Verlet, velocity Verlet and leapfrog step through the same positions, to roundoff");

    const double good = start_order(verlet, "start_taylor.tsv", out);
    const double careless = start_order(CarelessStart(), "start_careless.tsv", out);
    const double euler = start_order(EulerStart(), "start_euler.tsv", out);
    std::printf(
        "  order with the first step x + h v + h^2/2 a: %.2f\n"
        "  without the force: %.2f; with semi-implicit Euler: %.2f\n",
        good, careless, euler);
    out.number("start_good", good, "", "order of the positions with a good first step");
    out.number("start_careless", careless, "", "order with a first step without the force");
    out.number("start_euler", euler, "", "order with semi-implicit Euler's first step");
    out.check("start_matters",
              std::fabs(good - 2) < 0.05 && std::fabs(careless - 1) < 0.05 && std::fabs(euler - 1) < 0.05,
              "one careless first step takes the order of the whole run from two to one");
}
