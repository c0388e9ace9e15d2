// What a minute at the chosen step leaves of energy and angular momentum.

#include <cmath>
#include <cstdio>

#include "sections.hpp"

using namespace timestep;

void minute(const Settings& settings, lab::Findings& out) {
    out.section("A minute");
    const auto start = spinning(1, 10, 0.1);
    auto& table =
        out.table("minute.tsv", {"solver", "sides 1:2:3, energy", "momentum", "moments 1:2:3, energy", "momentum"});
    const PrincipalInertia<double> brick = box(1.0, 1.0, 2.0, 3.0), other{1, 2, 3};
    for (const Solver& solver : solvers()) {
        std::vector<lab::Cell> cells{solver.name};
        for (const auto* inertia : {&brick, &other}) {
            double E0 = kinetic_energy(*inertia, start), L0 = angular_momentum(*inertia, start).norm();
            RigidState<double> end = start;
            spin_on(solver, *inertia, start, settings.step, std::lround(60 / settings.step),
                    [&](const RigidState<double>& s) {
                        end = s;
                        return is_finite(s) && kinetic_energy(*inertia, s) < 1e6 * E0;
                    });
            const double E = kinetic_energy(*inertia, end) / E0, L = angular_momentum(*inertia, end).norm() / L0;
            const bool burst = !(E < 1e6);
            char energy[40], momentum[40];
            std::snprintf(energy, sizeof energy, burst ? "blown up after %.2f s" : "%.3f", burst ? end.t : E);
            std::snprintf(momentum, sizeof momentum, burst ? "–" : "%.3f", L);
            cells.push_back(std::string(energy)), cells.push_back(std::string(momentum));
            const std::string id = (inertia == &brick ? "minute_" : "minute_other_") + solver.key;
            std::printf("  %-25s %-14s energy %s, momentum %s\n", solver.name.c_str(),
                        inertia == &brick ? "sides 1:2:3" : "moments 1:2:3", energy, momentum);
            const std::string& k = solver.key;
            const std::string of = inertia == &brick ? "the box" : "the body with moments 1:2:3";
            if (k == "explicit") out.check(id, burst, "explicit: " + of + " blows up within the minute");
            if (k == "implicit" || k == "converged" || k == "passive")
                out.check(id, E < (k == "passive" ? 1 : 0.5),
                          k == "passive"
                              ? "passive: after a minute " + of + " has gained no energy"
                              : solver.name + (": after a minute " + of) + " has lost more than half of its energy");
            if (k == "implicit" || k == "converged")
                out.check(
                    id + "_momentum", L < 0.9,
                    solver.name + (": after a minute " + of) + " has lost more than a tenth of its angular momentum");
            if (k == "lagged_inertia")
                out.check(id + "_momentum", std::fabs(L - 1) < 1e-9,
                          "lagged inertia: the angular momentum of " + of + " stays");
        }
        table.row(cells);
    }
}
