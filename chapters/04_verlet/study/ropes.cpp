// A rope: what games use Verlet for. How stiff it is, and what that costs.

#include <algorithm>
#include <cstdio>
#include <vector>

#include <Eigen/Core>

#include <timestep/rope.hpp>

#include "sections.hpp"

using namespace timestep;
using Eigen::Vector2d;

namespace {

const double g = 9.81, link = 0.1;
const std::size_t links = 20;

Rope<Vector2d> hanging() { return {Vector2d(0, 0), Vector2d(0, -1), links, link, Projectile(Vector2d(0, -g))}; }
Rope<Vector2d> level() { return {Vector2d(0, 0), Vector2d(1, 0), links, link, Projectile(Vector2d(0, -g))}; }

// How much too long the rope hangs once it is at rest. Its slowest motion fades sweep by sweep, as
// much in many steps with one as in few with many: in 7200 of them below 1e-8 of it.
double stretch_at_rest(double rate, int sweeps) {
    Rope rope = hanging();
    for (int n = 0; n < 7200 / sweeps; ++n) rope.step(1 / rate, sweeps);
    return rope.stretch();
}

std::string cell(double value) {
    char text[16];
    std::snprintf(text, sizeof text, "%.2g", 100 * value);
    return std::string(text) + " %";
}

void stretch_table(const Settings& settings, lab::Findings& out) {
    auto& summary = out.table("stretch.tsv", {"iterations a step", "60 Hz", "120 Hz", "240 Hz", "480 Hz"});
    const double rates[] = {60, 120, 240, 480};
    double quarter = 0, budget[4] = {}, first = 0, at_8 = 0;
    std::vector<std::vector<double>> by_rate(4);
    for (const int sweeps : {1, 2, 4, 8, 16, 32, 64}) {
        double found[4];
        for (std::size_t i = 0; i < 4; ++i) {
            found[i] = stretch_at_rest(rates[i], sweeps);
            if (int(rates[i]) * sweeps == 480) budget[i] = found[i];
            by_rate[i].push_back(found[i]);
        }
        for (int i = 0; i < 3; ++i) quarter = std::max(quarter, std::fabs(found[i] / found[i + 1] / 4 - 1));
        if (sweeps == 1) first = found[0];
        if (sweeps == 8) at_8 = found[0];
        summary.row({double(sweeps), cell(found[0]), cell(found[1]), cell(found[2]), cell(found[3])});
    }
    auto& equal = out.table("stretch_budget.tsv", {"sweeps", "percent"});  // of 480 sweeps a second
    for (std::size_t i = 0; i < 4; ++i) {
        equal.row({480 / rates[i], 100 * budget[i]});
        auto& table = out.table("stretch_" + std::to_string(int(rates[i])) + ".tsv", {"sweeps", "percent"});
        for (std::size_t k = 0; k < by_rate[i].size(); ++k) table.row({double(1 << k), 100 * by_rate[i][k]});
    }
    const double own = stretch_at_rest(60, int(settings.sweeps));
    std::printf(
        "  %zu links of %g m, at rest, 60 steps a second: %.3g %% too long with 1 iteration a "
        "step,\n"
        "  %.3g %% with %ld\n",
        links, link, 100 * first, 100 * own, settings.sweeps);
    std::printf(
        "  480 iterations a second: 60 Hz %.3g %%, 120 Hz %.3g %%, 240 Hz %.3g %%,\n  480 Hz %.3g "
        "%%\n",
        100 * budget[0], 100 * budget[1], 100 * budget[2], 100 * budget[3]);
    out.number("links", double(links), "", "links of the rope");
    out.number("stretch_one", 100 * first, "%", "stretch at 60 Hz with one iteration", 2);
    out.number("stretch_many", 100 * budget[0], "%", "stretch at 60 Hz with eight iterations", 2);
    out.number("stretch_fast", 100 * budget[3], "%", "stretch at 480 Hz with one iteration", 2);
    out.number("stretch_gain", budget[0] / budget[3], "", "one over the other", 2);
    // At rest the sweeps take away what gravity adds in a step, h²g at every point, and while the
    // rope hangs straight all they do is linear: exactly a quarter, but for the rest that the
    // slowest motion has left.
    out.check("stretch_quarter", quarter < 1e-7,
              "half the step is a quarter of the stretch, for any number of iterations");
    out.check("sweeps_share", first / at_8 > 7 && first / at_8 < 9,
              "eight iterations a step stretch seven to nine times less than one");
    out.check("stretch_budget", budget[3] < budget[2] && budget[2] < budget[1] && budget[1] < budget[0],
              "for the same number of iterations a second, more steps with fewer iterations "
              "stretch less");

    // The stiffest springs that Verlet can carry have ωh = 1 (see below): they hang g (n + 1) h²/2L
    // too long on the mean, and one sweep (n − 1) where they have (n + 1): the derivation stands in
    // tests/library/rope.cpp.
    const double stiffest = 100 * g * (double(links) + 1) / (2 * link * 480 * 480);
    out.number("stretch_springs", stiffest, "%", "stretch of the stiffest springs that hold at 480 Hz", 2);
    const double one_sweep = g * (double(links) - 1) / (2 * link * 480 * 480);
    out.check(
        "sweep_is_stiffest",
        std::fabs(budget[3] / one_sweep - 1) < 1e-7 && 100 * budget[3] > 0.8 * stiffest && 100 * budget[3] < stiffest,
        "one iteration a step hangs about as little too long as the stiffest springs that the "
        "step can carry: within a fifth");

    // A chain of springs that hangs as little too long: g n/(2ω²L) on the mean, hence ω. Its
    // fastest swing has 2ω, and Verlet holds while that times h is below 2.
    const double n = double(links);
    const double spring_omega = std::sqrt(g * (n + 1) / (2 * link * at_8));
    out.number("spring_rate_needed", spring_omega, "Hz", "steps a second that springs as stiff need");
    const auto blows_up = [&](double h) {
        std::vector<State<double>> now, before;
        for (std::size_t i = 0; i <= links; ++i) now.push_back({0, -double(i) * link, 0});
        before = now;
        double farthest = 0;
        for (int k = 0; k < 20000 && farthest < 1e3; ++k) {
            std::vector<State<double>> next = now;
            for (std::size_t i = 1; i <= links; ++i) {
                const double pull = spring_omega * spring_omega;
                double a = -g + pull * (now[i - 1].x - now[i].x - link);
                if (i < links) a -= pull * (now[i].x - now[i + 1].x - link);
                next[i] = verlet.step(Projectile(a), before[i], now[i], h);
            }
            before = now;
            now = next;
            farthest = std::max(farthest, std::fabs(now[links].x));
        }
        return farthest >= 1e3;
    };
    std::printf("  springs as stiff as 8 iterations need %.0f steps a second, or they blow up\n", spring_omega);
    out.check("springs_blow_up", blows_up(1.02 / spring_omega) && !blows_up(0.98 / spring_omega),
              "a chain of springs as stiff as eight iterations blows up with a step 2 % longer "
              "than 1/omega");
}

// Let go from the level with any step. At rest with one sweep the rope hangs n(n − 1)/2 h²g too
// long (tests/library/rope.cpp). At the bottom of its swing it pulls with three times its weight,
// as any pendulum let go from there, and what is pulled all at once goes twice as far as it comes
// to rest: six times in all. What blows up passes any bound, and overflows.
void any_step(lab::Findings& out) {
    const double n = double(links);
    double worst = 0;
    for (const double rate : {1.0, 10.0, 60.0, 240.0})
        for (const int sweeps : {1, 2, 8, 32}) {
            Rope rope = level();
            double farthest = 0;
            for (int k = 0; k < 3000; ++k) {
                rope.step(1 / rate, sweeps);
                for (const auto& p : rope.points()) farthest = std::max(farthest, p.x.norm());
            }
            const double hangs = n * (n - 1) / 2 * g / (rate * rate);
            worst = std::max(worst, (farthest - n * link) / hangs);
        }
    std::printf(
        "  3000 steps of 1/240 to 1 s, 1 to 32 iterations: it gets longer by %.2g times what it\n"
        "  hangs too long with one iteration, at the most\n",
        worst);
    out.check("rope_holds", worst < 6,
              "with steps of 1/240 to 1 s and 1 to 32 iterations the rope gets longer by less than six "
              "times what it hangs too long with one iteration");
}

// Let go from the level: the shape, and the energy that the links take away.
void swing(lab::Findings& out) {
    const double rate = 60, h = 1 / rate;
    const double hung = -g * link * double(links + 1) / 2;  // mean potential of the hanging rope, per mass
    auto& frames = out.table("rope_frames.tsv", {"t", "x1", "y1", "x4", "y4", "x32", "y32"});
    const int sweeps[] = {1, 4, 32};
    std::vector<Rope<Vector2d>> ropes(3, level());
    double longest[3] = {};
    for (int n = 0; n <= 240; ++n) {
        if (n % 4 == 0) {
            for (std::size_t i = 0; i <= links; ++i)
                frames.row({n * h, ropes[0].points()[i].x(0), ropes[0].points()[i].x(1), ropes[1].points()[i].x(0),
                            ropes[1].points()[i].x(1), ropes[2].points()[i].x(0), ropes[2].points()[i].x(1)});
            frames.gap(), frames.gap();
        }
        for (std::size_t k = 0; k < 3; ++k) {
            ropes[k].step(h, sweeps[k]);
            longest[k] = std::max(longest[k], ropes[k].stretch());
        }
    }
    std::printf(
        "  let go from the level, at its longest: +%.3g %% with 1 iteration,\n"
        "  +%.3g %% with 4, +%.2g %% with 32\n",
        100 * longest[0], 100 * longest[1], 100 * longest[2]);
    for (std::size_t k = 0; k < 3; ++k)
        out.number("longest_" + std::to_string(sweeps[k]), 100 * longest[k], "%", "longest stretch in the oscillation",
                   2);

    // Energy over that of the level rope, measured from the hanging one.
    const auto energy = [&](double steps_a_second, int n_sweeps, const std::string& file, double& at_end) {
        auto& table = out.table(file, {"t", "energy"});
        Rope rope = level();
        double most = 0;
        for (long n = 1; n <= std::lround(20 * steps_a_second); ++n) {
            std::vector<Vector2d> before;
            for (const auto& p : rope.points()) before.push_back(p.x);
            rope.step(1 / steps_a_second, n_sweeps);
            double sum = 0;
            for (std::size_t i = 1; i <= links; ++i) {  // of the middle of the step, where its velocity belongs
                const double y = (before[i](1) + rope.points()[i].x(1)) / 2;
                sum += rope.velocity(i, 1 / steps_a_second).squaredNorm() / 2 + g * y;
            }
            at_end = (sum / double(links) - hung) / -hung;
            most = std::max(most, at_end);
            if (n % std::lround(steps_a_second / 30) == 0) table.row({double(n) / steps_a_second, at_end});
        }
        return most;
    };
    double end_4 = 0, end_32 = 0, end_fast = 0;
    const double most =
        std::max({energy(60, 4, "rope_energy_4.tsv", end_4), energy(60, 32, "rope_energy_32.tsv", end_32),
                  energy(480, 4, "rope_energy_fast.tsv", end_fast)});
    std::printf(
        "  energy after 20 s, of 1 at the start: 60 Hz 4 iterations %.3f, 32 iterations %.3f;\n"
        "  480 Hz 4 iterations %.3f; and at the most %.4f\n",
        end_4, end_32, end_fast, most);
    out.number("rope_energy_4", end_4, "", "rope's energy after 20 s at 60 Hz, 4 iterations", 2);
    out.number("rope_energy_32", end_32, "", "the same with 32 iterations", 2);
    out.number("rope_energy_fast", end_fast, "", "at 480 Hz with 4 iterations", 2);
    out.check("rope_loses", most < 1.001 && end_4 < 0.1 && end_32 < 0.1 && end_fast > 0.2,
              "no rope gains energy; at 60 Hz the oscillation is gone after 20 s, at 480 Hz part of it "
              "is left");
}

}  // namespace

void ropes(const Settings& settings, lab::Findings& out) {
    out.section("A rope");
    stretch_table(settings, out);
    any_step(out);
    swing(out);
}
