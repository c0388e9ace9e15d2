// What a minute leaves of energy and angular momentum.

#include <cmath>
#include <cstdio>

#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

struct Case {
    const char *id, *words;
    Body inertia;
    Spin start;
};

std::string three(double value) {
    char text[32];
    std::snprintf(text, sizeof text, std::fabs(value) < 1e6 ? "%.3f" : "%.1e", value);
    return std::isfinite(value) ? text : "gone";
}

}  // namespace

void minute(const Settings& settings, lab::Findings& out) {
    out.section("A minute");
    const auto pill = capsule(1.0, 0.15, 0.6);
    const Case cases[] = {
        {"box", "a box", box(1.0, 1.0, 2.0, 3.0), spinning(Vector(1, 10, 0.1))},
        {"pill", "a capsule, uneven", {pill.across, 1.02 * pill.across, pill.along}, spinning(Vector(0.5, 0, 20))},
        {"fast", "the box, fast", box(1.0, 1.0, 2.0, 3.0), spinning(Vector(10, 100, 1))}};
    const std::string L_of = ": $\\lvert L\\rvert$";  // | would end the table's cell
    auto& table = out.table("minute.tsv", {"method", "box: energy", "box" + L_of, "capsule: energy", "capsule" + L_of,
                                           "fast box: energy", "fast box" + L_of});
    const long steps = std::lround(60 / settings.step);
    std::printf("  %-24s %15s %15s %15s\n", "energy and momentum", "box", "capsule", "fast box");
    for (const Method& method : methods()) {
        const std::string& k = method.key;
        std::vector<lab::Cell> cells{method.name};
        std::printf("  %-24s", method.name.c_str());
        auto& history = out.table("minute_" + k + ".tsv", {"t", "energy_off", "momentum_off"});
        for (const Case& c : cases) {
            const std::string id = c.id;
            const auto L = [&](const Spin& s) { return c.inertia.momentum(s.omega).norm(); };
            const double E0 = kinetic_energy(c.inertia, c.start.omega), L0 = L(c.start);
            const Steps steps_of = method.made(c.inertia);
            Spin s = c.start;
            double E = 1, M = 1, off_E = 0, off_L = 0;
            for (long n = 0; n <= steps; ++n) {
                E = kinetic_energy(c.inertia, s.omega) / E0, M = L(s) / L0;
                off_E = larger(off_E, std::fabs(E - 1)), off_L = larger(off_L, std::fabs(M - 1));
                if (id == "box" && n % 6 == 0) history.row({s.t, off_E, off_L});
                s = steps_of(s, settings.step, 1);
            }
            cells.push_back(three(E)), cells.push_back(three(M));
            std::printf(" %7s %7s", three(E).c_str(), three(M).c_str());
            const auto name = [&](const char* what) { return "minute_" + k + "_" + id + what; };
            // A few ε a step, at the worst all one way.
            const double roundoff = 26 * 2.3e-16 * double(steps);
            const std::string of = std::string(": ") + c.words;
            if (k == "cayley")
                out.check(name("_keeps"), off_E < roundoff, "Cayley" + of + " keeps its energy to roundoff");
            if (k == "calm")
                out.check(name("_keeps"), off_E < roundoff && off_L < roundoff,
                          "the calm half-step" + of + " keeps energy and |L| to roundoff");
            if (k == "strang" || k == "remainder_2" || k == "remainder_4")
                out.check(name("_keeps"), off_L < roundoff, method.name + of + " keeps |L| to roundoff");
            if (k == "remainder_4")
                out.check(name("_energy"), off_E < 1e-4, method.name + of + " keeps its energy to a ten-thousandth");
        }
        std::printf("\n");
        table.row(cells);
    }
    // How long does the uneven capsule keep half of its spin about its length?
    const Case& pill_case = cases[1];
    const double patience = 600;
    const auto keeps = [&](const Method& method) {
        const Steps steps_of = method.made(pill_case.inertia);
        Spin s = pill_case.start;
        while (s.t < patience && s.omega.z() > pill_case.start.omega.z() / 2) s = steps_of(s, settings.step, 1);
        std::printf("  %s: half of the capsule's spin gone %s %.0f s\n", method.name.c_str(),
                    s.t < patience ? "after" : "not yet after", s.t);
        return s.t;
    };
    const double passive = keeps(method("passive")), cayley = keeps(method("cayley"));
    const double remainder = keeps(method("remainder_2"));
    out.number("length_passive", passive, "s", "passive: when the uneven capsule has lost half of its spin", 2);
    out.number("length_cayley", cayley, "s", "Cayley: when it has", 2);
    out.number("length_patience", patience, "s", "how long it was watched");
    out.text("length_start", "(0.5, 0, 20) rad/s", "its spin at the start");
    out.check("length_cayley", passive < 5 && cayley > 20 * passive && cayley < patience,
              "the uneven capsule keeps its spin more than 20 times as long by Cayley as by "
              "passive, and loses it, too");
    // And a wheel, which spins about its largest moment: there the passive step takes nothing.
    const PrincipalInertia<double> wheel(1, 1.02, 1.9);
    const auto wheel_keeps = [&](const auto& solver) {
        Vector3<double> omega(0.6, 0, 30);
        double t = 0;
        for (; t < patience && omega.z() > 15; t += settings.step) omega = solver.step(wheel, omega, settings.step);
        return t;
    };
    const double wheel_cayley = wheel_keeps(cayley_gyroscopic);
    out.number("wheel_cayley", wheel_cayley, "s", "Cayley: when a wheel at 30 rad/s has lost half of its spin", 2);
    out.check(
        "wheel",
        wheel_cayley < 60 && wheel_keeps(passive_gyroscopic) >= patience && wheel_keeps(half_step_jacobian) >= patience,
        "a wheel at 30 rad/s loses half of its spin within a minute by Cayley, and keeps it "
        "by passive and by the half-step Jacobian");
    out.check("length_remainder", remainder >= patience, "ball and remainder 2: the uneven capsule keeps its spin");
}
