// Substeps against iterations; what a method has to forget after a kick; and the mass that a spring
// feels.

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <Eigen/Dense>

#include <timestep/methods/bdf2.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/verlet.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double frame = 1.0 / 60;
constexpr double point = 1;  // kg, of the rope

// A rope of points that hangs from a hook, and carries a load. How much too long is it at rest? One
// place a point will do, as it hangs straight. Each move shrinks by 10/s, and is zero at rest.
double too_long(int steps, int sweeps, double load) {
    const int links = 10;
    const double length = 0.1, h = frame / steps, keep = std::exp(-10 * h);
    std::array<double, links + 1> x, before,
        w;  // depth, that of the step before, one over the mass
    for (int i = 0; i <= links; ++i) x[i] = before[i] = i * length, w[i] = i == 0 ? 0 : 1 / (i == links ? load : point);
    for (int n = 0; n < 3600 * steps; ++n) {
        for (int i = 1; i <= links; ++i) {
            const double next = x[i] + keep * (x[i] - before[i]) + h * h * 9.81;
            before[i] = x[i], x[i] = next;
        }
        for (int sweep = 0; sweep < sweeps; ++sweep)
            for (int i = 1; i <= links; ++i) {
                const double share = (x[i] - x[i - 1] - length) / (w[i - 1] + w[i]);
                x[i - 1] += w[i - 1] * share, x[i] -= w[i] * share;
            }
    }
    return x[links] / (links * length) - 1;
}

void substeps(lab::Findings& out) {
    const double load = 20;
    auto& table = out.table("substeps.tsv", {"sweeps", "iterations", "substeps"});
    double iterations = 0, steps = 0, slope = 0, four = 0, sixteen = 0;
    for (const int n : {1, 2, 4, 8, 16, 32}) {
        const double last = steps;
        iterations = too_long(1, n, load), steps = too_long(n, 1, load);
        if (n == 4) four = steps;
        if (n == 16) sixteen = iterations;
        if (n > 1) slope = std::log2(last / steps);
        table.row({double(n), 100 * iterations, 100 * steps});
        std::printf(
            "  a load of %g kg, %2d sweeps a frame: %8.4g %% too long in one step, %8.4g %% in %d "
            "substeps\n",
            load, n, 100 * iterations, 100 * steps, n);
    }
    out.number("sub_mass", point, "kg", "a point of the rope");
    out.number("sub_load", load, "kg", "the load on the rope");
    out.number("sub_sweeps", 32, "", "sweeps a frame");
    out.number("sub_iterations", 100 * iterations, "%", "too long with so many iterations in one step", 2);
    out.number("sub_steps", 100 * steps, "%", "and with as many substeps of one sweep", 2);
    out.number("sub_four", 100 * four, "%", "with four substeps of one sweep", 2);
    out.number("sub_sixteen", 100 * sixteen, "%", "with sixteen iterations in one step", 2);
    out.check("substeps_win",
              iterations > 20 * steps && std::fabs(four / sixteen - 1) < 0.1 && std::fabs(slope - 2) < 0.01,
              "32 substeps leave less than a twentieth of what 32 iterations leave of a loaded "
              "rope's stretch; four substeps "
              "are within a tenth of sixteen iterations; twice the substeps are a quarter of the "
              "stretch");
}

// From rest, kicked to 1 m/s after ten steps. `told` methods begin anew, the others go on as if
// nothing had been.
enum class Method { bdf2, adams_bashforth, verlet };
std::vector<double> kicked(Method method, bool told) {
    const Projectile nothing(0.0);
    const double h = frame;
    State<double> now{0, 0, 0}, before{-h, 0, 0};
    std::vector<double> places{0};
    for (int n = 1; n <= 40; ++n) {
        if (n == 11) {
            now.v += 1;
            if (told && method == Method::verlet) before.x -= h * 1;  // the stored place makes the velocity
            if (told && method != Method::verlet) before = {now.t - h, now.x - h * now.v, now.v};
        }
        State<double> next{now.t + h, 0, now.v};  // no force: the velocity stays
        if (method == Method::bdf2) next = bdf2.step(nothing, before, now, h);
        if (method == Method::adams_bashforth) next.x = now.x + h * (1.5 * now.v - 0.5 * before.v);
        if (method == Method::verlet) next.x = verlet.step(nothing, before, now, h).x;
        before = now, now = next;
        places.push_back(now.x);
    }
    return places;
}

void restarts(lab::Findings& out) {
    const auto bdf = kicked(Method::bdf2, false), adams = kicked(Method::adams_bashforth, false),
               stored = kicked(Method::verlet, false);
    auto& table = out.table("kick.tsv", {"t", "exact", "bdf2", "adams", "verlet"});
    double worst = 0;
    for (std::size_t n = 0; n < bdf.size(); ++n) {
        const double exact = n < 10 ? 0 : double(n - 10) * frame;
        table.row({double(n) * frame, exact, bdf[n], adams[n], stored[n]});
        for (const Method m : {Method::bdf2, Method::adams_bashforth, Method::verlet})
            worst = std::fmax(worst, std::fabs(kicked(m, true)[n] - exact));
    }
    const double ahead = adams.back() - 30 * frame;
    std::printf(
        "  a kick that nobody tells of: BDF2 gets %.3g as far, Adams-Bashforth is %.3g steps "
        "ahead, Verlet at %g;\n"
        "  told, all are within %.1e m\n",
        bdf.back() / (30 * frame), ahead / frame, stored.back(), worst);
    out.number("adams_ahead", ahead / frame, "", "steps by which Adams–Bashforth is ahead after a kick", 3);
    out.check("kick_restarts",
              worst < 1e-12 && stored.back() == 0 && std::fabs(ahead / frame - 0.5) < 1e-9 &&
                  std::fabs(bdf.back() / (30 * frame) - 1.5) < 0.1,
              "not told of a kick BDF2 goes half as fast again, Adams-Bashforth is half a step "
              "ahead and Verlet stays; told, "
              "all three are right to roundoff");
}

// A free body on one spring that takes hold at r and pulls along n: height of that point is n·x +
// (r×n)·turn.
struct Held {
    Eigen::Vector3d r, n, moments;
    double m, k;
    double inverse_mass() const {
        const Eigen::Vector3d arm = r.cross(n);
        return 1 / m + arm.dot(arm.cwiseQuotient(moments));
    }
    using Six = Eigen::Matrix<double, 6, 1>;
    Six acceleration(const Six& y) const {
        const Eigen::Vector3d arm = r.cross(n);
        const double pull = -k * (n.dot(y.head<3>()) + arm.dot(y.tail<3>()));
        Six a;
        a << Eigen::Vector3d(pull / m * n), Eigen::Vector3d((pull * arm).cwiseQuotient(moments));
        return a;
    }
};

double longest_step(const Held& body) {
    const auto holds = [&](double h) {
        State<Held::Six> start{0, Held::Six::Zero(), Held::Six::Zero()};
        start.x.head<3>() = 0.01 * body.n;
        return run(semi_implicit_euler, body, start, h, 20000).x.norm() < 100;
    };
    return largest_stable_step(holds, 0.2);
}

void effective_mass(lab::Findings& out) {
    const double m = 6,
                 k = 6000;  // a plank of 2 m by 0.2 m by 0.1 m, held a distance from its centre
    const Eigen::Vector3d moments = m / 12 * Eigen::Vector3d(0.04 + 0.01, 4 + 0.01, 4 + 0.04);
    auto& lines = out.table("effective_mass.tsv", {"arm", "formula", "naive"});
    auto& points = out.table("effective_mass_points.tsv", {"arm", "found"});
    double worst = 0, end = 0;
    for (int i = 0; i <= 40; ++i) {
        const double arm = i / 40.0;
        const Held body{{arm, 0.1, 0}, {0, 0, 1}, moments, m, k};
        const double formula = 2 / std::sqrt(k * body.inverse_mass());
        lines.row({arm, 1e3 * formula, 1e3 * 2 / std::sqrt(k / m)});
        if (i % 5 != 0) continue;
        const double found = longest_step(body);
        points.row({arm, 1e3 * found});
        worst = std::fmax(worst, std::fabs(found / formula - 1));
        if (i == 40) end = body.inverse_mass() * m;
    }
    std::printf("  a plank held at its corner feels as 1/%.3g of its mass; found against formula: %.1e\n", end, worst);
    out.number("corner_lighter", end, "", "how many times lighter a plank is to a spring at its corner", 3);
    out.check("effective_mass", worst < 1e-3 && end > 3,
              "the longest step of a body on one spring is 2 over the root of k/m_eff, found by "
              "running to a thousandth, and "
              "a plank's corner is over three times as light as the plank");
}

}  // namespace

void cures(const Settings&, lab::Findings& out) {
    out.section("Substeps, restarts, effective mass");
    substeps(out);
    restarts(out);
    effective_mass(out);
}
