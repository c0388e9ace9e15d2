// With a damper: how long may a step be?

#include <cstdio>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// The eigenvalues' magnitude is rounded a few times, by ε each.
constexpr double roundoff = 8 * 2.2e-16;

template <class Method>
double limit(const Method& method, double zeta) {
    const DampedSpring model(1.0, zeta);
    const auto stable = [&](double wh) { return spectral_radius(step_matrix(method, model, wh)) <= 1 + roundoff; };
    return largest_stable_step(stable, 20.0);
}

// λ = −ζ ± √(ζ² − 1) in units of ω are the spring's own rates; |1 + hλ| ≤ 1 for both.
double explicit_limit(double zeta) { return zeta <= 1 ? 2 * zeta : 2 / (zeta + std::sqrt(zeta * zeta - 1)); }
// At the limit an eigenvalue is −1: 1 + trace + determinant = 0, a quadratic for ωh.
double old_damping_limit(double zeta) { return 2 * (std::sqrt(1 + zeta * zeta) - zeta); }
double new_damping_limit(double zeta) { return 2 * (std::sqrt(1 + zeta * zeta) + zeta); }

}  // namespace

void damping(const Settings&, lab::Findings& out) {
    out.section("Damping and the longest stable step");
    std::printf("  %5s %20s %25s %25s\n", "zeta", "explicit", "semi-implicit, old v", "semi-implicit, new v");
    auto& lines = out.table("damping_lines.tsv", {"zeta", "explicit", "old", "new"});
    auto& points = out.table("damping_points.tsv", {"zeta", "explicit", "old", "new"});
    double worst = 0;
    for (int i = 0; i <= 300; ++i) {
        const double zeta = i / 100.0;
        const double predicted[] = {explicit_limit(zeta), old_damping_limit(zeta), new_damping_limit(zeta)};
        lines.row({zeta, predicted[0], predicted[1], predicted[2]});
        if (i % 25 != 0) continue;
        const double found[] = {limit(explicit_euler, zeta), limit(semi_implicit_euler, zeta),
                                limit(semi_implicit_euler_new_damping, zeta)};
        points.row({zeta, found[0], found[1], found[2]});
        for (int k = 0; k < 3; ++k) worst = std::max(worst, std::fabs(found[k] - predicted[k]));
        if (i % 50 == 0) std::printf("  %5.2f %20.6f %25.6f %25.6f\n", zeta, found[0], found[1], found[2]);
    }
    out.number("critical_old", limit(semi_implicit_euler, 1), "", "longest stable omega h at zeta = 1");
    out.number("critical_new", limit(semi_implicit_euler_new_damping, 1), "", "longest stable omega h at zeta = 1");
    out.check("damping_limits", worst < 1e-6, "the limits found by bisection are those of the formulas");
    out.check("damping_shrinks",
              limit(semi_implicit_euler, 1) < limit(semi_implicit_euler, 0) &&
                  limit(semi_implicit_euler_new_damping, 1) > limit(semi_implicit_euler_new_damping, 0),
              "damping at the old velocity shortens the longest step, at the new velocity it lengthens "
              "it");
}
