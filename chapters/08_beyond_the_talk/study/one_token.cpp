// The talk's solver and the one with half a step in its Jacobian, on a box spun about its middle
// axis.

#include <cmath>
#include <cstdio>

#include <timestep/gyroscopic/half_step_jacobian.hpp>

#include "sections.hpp"

using namespace timestep;

void one_token(const Settings& settings, lab::Findings& out) {
    out.section("One token");
    const Body brick = box(12.0, 1.0, 2.0, 3.0);
    const Spin start = spinning(Vector(settings.tilt, settings.spin, settings.tilt));
    const Exact exact(brick, start);
    const double E0 = kinetic_energy(brick, start.omega), seconds = 12;
    const long steps = std::lround(seconds / settings.step);

    auto& truth = out.table("token_exact.tsv", {"t", "omega_y"});
    for (long n = 0; n <= steps; ++n)
        truth.row({double(n) * settings.step, exact(double(n) * settings.step).omega.y()});

    double worst_of_talk = 0, lost_by_talk = 0;
    const auto follow = [&](const Method& method) {
        const std::string& k = method.key;
        const Steps steps_of = method.made(brick);
        auto& table = out.table("token_" + k + ".tsv", {"t", "energy", "omega_y", "error"});
        double worst = 0, least = 1, most = 1, squares = 0;
        Spin s = start;
        for (long n = 0; n <= steps; ++n) {
            const double E = kinetic_energy(brick, s.omega) / E0;
            const double error = (s.omega - exact(s.t).omega).norm() / settings.spin;
            table.row({s.t, E, s.omega.y(), error});
            worst = std::max(worst, error), least = std::min(least, E), most = std::max(most, E);
            squares += error * error;
            if (n < steps) s = steps_of(s, settings.step, 1);
        }
        const double E = kinetic_energy(brick, s.omega) / E0;
        const double rms = std::sqrt(squares / double(steps));
        std::printf(
            "  %-18s  energy x %.3f, on the way x %.4f to %.4f; omega off by %.2g %% (at most %.2g "
            "%%)\n",
            method.name.c_str(), E, least, most, 100 * rms, 100 * worst);
        out.number("token_" + k + "_energy", E, "", "energy at the end over that at the start");
        if (k == "implicit") worst_of_talk = worst, lost_by_talk = 1 - E;
        if (k == "half_step") {
            out.number("token_swing", 100 * std::max(1 - least, most - 1), "%", "how far the energy is off at most", 2);
            out.check("token_energy", std::max(1 - least, most - 1) < 0.1 * lost_by_talk,
                      "the half-step Jacobian's energy is off by less than a tenth of what the "
                      "talk's solver loses");
            out.check("token_error", worst < worst_of_talk,
                      "the half-step Jacobian's worst error in ω is below the talk's");
        }
    };
    follow(method("implicit"));
    follow(method("half_step"));
    out.number("token_seconds", seconds, "s", "how long the box is watched");
    out.text("token_moments", "(13, 10, 5) kg m²", "moments of the box");
    out.number("token_spin", settings.spin, "rad/s", "its spin about the intermediate axis");

    // Does the energy drift? A quarter of an hour, the mean of the first and of the last minute.
    double first = 0, last = 0;
    const long all = 54000, part = 3600;
    Vector w = start.omega;
    for (long n = 0; n < all; ++n) {
        const double E = kinetic_energy(brick, w) / E0;
        if (n < part) first += E / double(part);
        if (n >= all - part) last += E / double(part);
        w = half_step_jacobian.step(brick, w, settings.step);
    }
    std::printf("  half-step Jacobian, mean energy: first minute x %.6f, 15th x %.6f\n", first, last);
    out.check("token_no_drift", std::fabs(last - first) < 1e-3,
              "after a quarter of an hour the half-step Jacobian's energy has not drifted");
}
