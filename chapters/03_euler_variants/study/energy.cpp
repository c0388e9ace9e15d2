// What the three Eulers do to the energy of the spring.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

template <class Method>
void energy_of(const Method& method, const Settings& settings, lab::Findings& out) {
    const Spring spring(settings.omega);
    const State start{0, 1.0, 0.0};
    auto& table = out.table("energy_" + lab::id(Method::name) + ".tsv", {"t", "energy"});
    run(method, spring, start, settings.step, settings.steps, [&](const auto& s) {
        table.row({s.t, spring.energy(s) / spring.energy(start)});
    });
}

// What semi-implicit Euler does to the energy of a pendulum that is let go at rest.
struct Swung {
    double least = 1, most = 1;  // energy, over that of the start
    long over = -1;              // the first step beyond the top, which its energy does not reach
};

Swung swung(double angle, double wh, long steps) {
    const Pendulum pendulum(1.0);
    const State start{0, angle, 0.0};
    Swung result;
    long n = 0;
    run(semi_implicit_euler, pendulum, start, wh, steps, [&](const auto& s) {
        const double energy = pendulum.energy(s) / pendulum.energy(start);
        result.least = std::min(result.least, energy), result.most = std::max(result.most, energy);
        if (result.over < 0 && std::fabs(s.x) > pi + 1) result.over = n;
        ++n;
    });
    return result;
}

// On a spring the band is proven (see below); on a pendulum it is found, and only for steps that
// are short enough.
void pendulums(lab::Findings& out) {
    const double calm = 0.5, wild = 1, near_top = 3.1;
    const long starts = 31, calm_steps = 100000, wild_steps = 1000000;
    double least = 1, most = 1;
    bool over = false;
    for (long i = 1; i <= starts; ++i) {
        const Swung one = swung(near_top * double(i) / starts, calm, calm_steps);
        least = std::min(least, one.least), most = std::max(most, one.most), over = over || one.over >= 0;
    }
    // With longer steps those let go from higher up go over the top.
    auto& table = out.table("pendulums.tsv", {"ωh", "go over the top", "the lowest of them, let go at (rad)"});
    double most_wild = 0, lowest_wild = 0;
    std::vector<long> counts;
    for (const double wh : {1.0, 0.9, 0.8, 0.7, 0.6, 0.5}) {
        long count = 0;
        double lowest = 0;
        for (long i = starts; i >= 1; --i) {
            const double angle = near_top * double(i) / starts;
            const Swung one = swung(angle, wh, wh == wild ? wild_steps : calm_steps);
            if (wh == wild) most_wild = std::max(most_wild, one.most);
            if (one.over >= 0) ++count, lowest = angle;
        }
        if (wh == wild) lowest_wild = lowest;
        std::printf("  pendulums, omega h = %g: %ld of %ld go over the top", wh, count, starts);
        count > 0 ? std::printf(", let go from %.3g rad on\n", lowest) : std::printf("\n");
        table.row({wh, double(count), count > 0 ? lab::Cell(lowest) : lab::Cell("none")});
        counts.push_back(count);
    }
    std::printf(
        "  pendulums, omega h = %g, let go from %g to %g rad: energy between %.3f and %.3f of the "
        "first;\n"
        "  omega h = %g: up to %.2f times the first\n",
        calm, near_top / starts, near_top, least, most, wild, most_wild);
    out.number("pendulum_starts", double(starts), "", "pendulums let go at rest");
    out.number("pendulum_near_top", near_top, "rad", "the last of them, from hanging");
    out.number("pendulum_calm", calm, "", "omega h at which they keep their energy in the band");
    out.number("pendulum_calm_steps", double(calm_steps), "", "steps of each");
    out.number("pendulum_wild", wild, "", "omega h at which some go over the top");
    out.number("pendulum_wild_steps", double(wild_steps), "", "steps of it");
    out.number("pendulum_wild_count", double(counts.front()), "", "how many go over the top at omega h = 1");
    out.number("pendulum_wild_lowest", lowest_wild, "rad", "the lowest start of those", 2);
    out.number("pendulum_wild_most", most_wild, "", "the greatest energy of any, over its first", 2);
    out.check("pendulum_band", !over && least > 1 / (1 + calm / 2) && most < 1 / (1 - calm / 2),
              "at omega h = 0.5, 31 pendulums let go from 0.1 to 3.1 rad keep their energy within "
              "the spring's band for "
              "100,000 steps, and none goes over the top");
    out.check(
        "pendulum_over",
        counts.front() > 1 && std::is_sorted(counts.rbegin(), counts.rend()) && counts.back() == 0 && most_wild > 2,
        "at omega h = 1 several of them go over the top, and the energy of one is at some "
        "time over twice that of the start; "
        "fewer do at 0.9, 0.8, 0.7, 0.6, and at 0.5 none");
}

}  // namespace

// Semi-implicit Euler keeps another energy than the true one. With v₂ = v₁ − hω²x₁ and x₂ = x₁ +
// hv₂
//     ½v² + ½ω²x² − ½hω²xv
// is the same before and after a step: an ellipse, slightly tilted, on which the state stays while
// ωh < 2. The true energy differs by the last term, so it swings in a fixed band.
void energies(const Settings& settings, lab::Findings& out) {
    energy_of(explicit_euler, settings, out);
    energy_of(implicit_euler, settings, out);
    energy_of(semi_implicit_euler, settings, out);

    const Spring spring(settings.omega);
    const double h = settings.step, w2 = settings.omega * settings.omega;
    const auto kept = [&](const State<double>& s) { return spring.energy(s) - h * w2 * s.x * s.v / 2; };
    const State start{0, 1.0, 0.0};
    double least = 1, most = 1, sum = 0, drift = 0;
    const long steps = 1000000;
    run(semi_implicit_euler, spring, start, h, steps, [&](const auto& s) {
        const double energy = spring.energy(s) / spring.energy(start);
        least = std::min(least, energy);
        most = std::max(most, energy);
        sum += energy;
        drift = std::max(drift, std::fabs(kept(s) / kept(start) - 1));
    });
    const double mean = sum / (steps + 1);
    const double wh = settings.wh(), predicted = 1 / (1 - wh * wh / 4);
    // The same from a start that moves: here the kept energy is not the true one.
    const State moving{0, 1.0, settings.omega};
    double moving_sum = 0;
    run(semi_implicit_euler, spring, moving, h, steps, [&](const auto& s) { moving_sum += spring.energy(s); });
    const double moving_mean = moving_sum / (steps + 1) / (kept(moving) * predicted);

    out.section("Energy");
    if (wh < 2)
        std::printf(
            "  semi-implicit Euler, %ld steps: energy between %.4f and %.4f of the first,\n"
            "  mean %.5f (predicted %.5f); the energy it keeps drifts by %.1e\n",
            steps, least, most, mean, predicted, drift);
    else
        std::printf("  semi-implicit Euler grows without bound at omega h = %g: its energy has no mean\n", wh);
    out.number("energy_least", 100 * least, "%", "least energy of semi-implicit Euler");
    out.number("energy_most", 100 * most, "%", "greatest energy of semi-implicit Euler");
    out.number("energy_mean", 100 * mean, "%", "mean energy of semi-implicit Euler", 4);
    out.number("energy_drift", drift, "", "relative drift of the energy that semi-implicit Euler keeps", 2);
    out.number("energy_steps", double(steps), "", "steps of the long run");
    // On the ellipse the true energy is between 1/(1 + ωh/2) and 1/(1 − ωh/2) of the kept one. An
    // average over n steps is off by at most one swing of the band, over n.
    out.check("energy_band", wh < 2 && least > (1 - 1e-9) / (1 + wh / 2) && most < (1 + 1e-9) / (1 - wh / 2),
              "the energy of semi-implicit Euler stays in the band 1/(1 ± omega h/2)");
    out.check("energy_mean",
              wh < 2 && std::fabs(mean - predicted) < 20 / (1 - wh / 2) / wh / steps + 1e-9 &&
                  std::fabs(moving_mean - 1) < 40 / (1 - wh / 2) / (1 - wh / 2) / wh / steps + 1e-9,
              "the mean energy of semi-implicit Euler is its modified energy over 1 - (omega h)^2/4");
    pendulums(out);
}
