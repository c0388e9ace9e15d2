// Where one step of a gyroscopic solver adds energy: a search over bodies that could exist.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "random_body.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;
using Body = PrincipalInertia<double>;

// The energy after one step with h|ω| = size, over the energy before.
template <class Solver>
double gain(const Solver& solver, const Body& inertia, const V& direction, double size) {
    const V next = solver.step(inertia, direction, size);
    return kinetic_energy(inertia, next) / kinetic_energy(inertia, direction);
}

// A body whose largest moment is 1 and whose smallest is 1/ratio. The triangle rule leaves the
// middle one between 1 − 1/ratio and 1, at the place `middle` (0 to 1).
Body with_ratio(double ratio, double middle) {
    const double low = std::max(1 / ratio, 1 - 1 / ratio);
    return {1, low + (1 - low) * middle, 1 / ratio};
}

// The worst gain at a size and a ratio: darts, then small moves away from the best of them.
double worst_gain(double size, double ratio, std::mt19937_64& random) {
    std::uniform_real_distribution<double> even(0, 1);
    std::normal_distribution<double> normal;
    double best = 0, best_middle = 0;
    V best_direction = V::UnitX();
    for (int i = 0; i < 700; ++i) {
        const bool dart = i < 400;
        const double reach = 0.3 * std::pow(0.01, (i - 400) / 300.0);
        const V noise(normal(random), normal(random), normal(random));
        const V d = dart ? V(noise.normalized()) : V((best_direction + reach * noise).normalized());
        const double m = dart ? even(random) : std::clamp(best_middle + reach * normal(random), 0.0, 1.0);
        const double g = gain(implicit_gyroscopic, with_ratio(ratio, m), d, size);
        if (g > best) best = g, best_middle = m, best_direction = d;
    }
    return best;
}

std::string words(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// What a step that multiplies the energy by `gain` adds, as a share of it; roundoff is nothing.
std::string added(double gain) { return gain < 1 + 1e-12 ? "0" : words("%.2g", gain - 1); }

// Not inlined: g++ 12 at -O3 takes double → float → double for no change where it does so with
// several numbers at once.
[[gnu::noinline]] PrincipalInertia<float> rounded(const Body& inertia) {
    return {float(inertia.moments.x()), float(inertia.moments.y()), float(inertia.moments.z())};
}

// How many times its |ω| of now a free body reaches as it tumbles. Energy and momentum make the
// squares of two components linear in the third, and with them |ω|²: it is largest at an end of its
// way, where one component vanishes.
double swell(const Body& inertia, const V& omega) {
    const V I = inertia.moments, squares = omega.cwiseAbs2();
    const double E2 = I.dot(squares), L2 = I.cwiseAbs2().dot(squares);
    double most = squares.sum();
    for (int i = 0; i < 3; ++i) {
        const double a = I[i], b = I[(i + 1) % 3];
        const double x = (L2 - b * E2) / (a * (a - b)), y = (L2 - a * E2) / (b * (b - a));
        if (x >= 0 && y >= 0) most = std::max(most, x + y);
    }
    return std::sqrt(most / squares.sum());
}

}  // namespace

void energy_map(const Settings& settings, lab::Findings& out) {
    out.section("One iteration can add energy");

    // One body, one step.
    const Body plank(0.758, 0.787, 0.0313);
    const V spin(-0.973, -0.137, -0.184);
    const double one = gain(implicit_gyroscopic, plank, spin, 1), passive = gain(passive_gyroscopic, plank, spin, 1),
                 all = gain(converged_gyroscopic, plank, spin, 1);
    std::printf("  I = (0.758, 0.787, 0.0313), omega = (-0.973, -0.137, -0.184), h = 1 s:\n");
    std::printf("  energy x %.3f by one Newton step, x %.3f converged, x %.3f passive\n", one, all, passive);
    out.number("example_gain", one, "", "what one Newton step multiplies the energy by");
    out.number("example_passive", passive, "", "what the passive step multiplies it by");
    out.number("example_converged", all, "", "what the converged step multiplies it by");
    out.check("example", one > 1.7 && passive <= 1 && all <= 1,
              "one Newton step adds energy to this body, the other two add none");

    // Random bodies, ratio of moments up to 1000.
    auto& gains = out.table("gains.tsv",
                            {"$h\\lvert\\omega\\rvert$", "one Newton step: bodies that gain at all",
                             "one Newton step: largest gain, share of E", "converged: the same", "passive: the same"});
    auto& curve = out.table("gain_curve.tsv", {"size", "share", "implicit", "converged", "passive"});
    RandomBody bodies(2);
    for (int i = -8; i <= 8; ++i) {
        const double size = std::pow(10.0, i / 8.0);
        double implicit_worst = 0, converged_worst = 0, passive_worst = 0, gained = 0;
        const int many = 8000;
        for (int n = 0; n < many; ++n) {
            const Body inertia = bodies.inertia(1000);
            const V d = bodies.direction();
            const double g = gain(implicit_gyroscopic, inertia, d, size);
            gained += g > 1 + 1e-12;
            implicit_worst = std::max(implicit_worst, g);
            passive_worst = std::max(passive_worst, gain(passive_gyroscopic, inertia, d, size));
            if (n % 8 == 0) converged_worst = std::max(converged_worst, gain(converged_gyroscopic, inertia, d, size));
        }
        curve.row({size, gained / many, implicit_worst, converged_worst, passive_worst});
        if (i % 4 == 0)
            gains.row({words("%.2g", size), words("%.2g %%", 100 * gained / many), added(implicit_worst),
                       added(converged_worst), added(passive_worst)});
        if (i == 0) {
            std::printf("  at h|omega| = 1, of %d random bodies %.1f %% gain, up to x %.3g\n", many,
                        100 * gained / many, implicit_worst);
        }
        if (i == 8) {
            std::printf("  at h|omega| = 10 up to x %.2g\n", implicit_worst);
            out.check("worst_at_10", implicit_worst > 100,
                      "at h|ω| = 10 one step multiplies the energy by more than a hundred");
        }
    }

    // The map: the worst gain over h|ω| and the ratio of the largest to the smallest moment.
    auto& map = out.table("energy_map.tsv", {"size", "ratio", "gain"});
    std::mt19937_64 random(3);
    double first = 1e9, first_ratio = 0, top = 0, top_1000 = 0, top_size = 0, top_ratio = 0;
    for (int j = 0; j <= 24; ++j) {
        const double ratio = 1.05 * std::pow(10.0, j / 4.0);
        for (int i = 0; i <= 32; ++i) {
            const double size = std::pow(10.0, -1.5 + i / 12.0);
            const double g = worst_gain(size, ratio, random);
            map.row({size, ratio, g});
            if (size <= 1.0001 && ratio <= 1100) top_1000 = std::max(top_1000, g);
            if (size <= 1.0001 && g > top) top = g, top_size = size, top_ratio = ratio;
            if (g > 1.01 && size < first) first = size, first_ratio = ratio;
        }
        map.gap();
    }
    std::printf("  worst found up to h|omega| = 1: x %.3g, at %.2g and a ratio of %.2g\n", top, top_size, top_ratio);
    std::printf("  a gain of 1 %% begins at h|omega| = %.2g (ratio %.0f): %.1f rad/s at this step\n", first,
                first_ratio, first / settings.step);
    std::printf("  with a ratio up to a thousand: x %.3g\n", top_1000);
    out.number("map_worst_1000", top_1000, "", "the worst gain found up to h|omega| = 1 and a ratio of some thousand");
    out.check("map_worse_than_random", top_1000 > 2,
              "the search finds worse than random bodies do: more than twice the energy");
    out.number("map_first", first, "", "least h|omega| on the map with a gain of a hundredth", 2);
    out.number("map_first_spin", first / settings.step, "rad/s", "the spin that this is", 2);
    out.number("map_first_turns", first / settings.step / (2 * pi), "turns/s", "the same in turns a second", 2);
    auto& edge = out.table("map_edge.tsv", {"size", "ratio"});
    edge.row({first, 1.0}), edge.row({first, 1.3e6});
    out.check("map_begins_below_one", first < 1, "a gain of a hundredth is met below h|ω| = 1");

    // Debris: many bodies, each for ten seconds, with h|ω| = 1 at the start.
    const int pieces = 500;
    int above = 0, above_passive = 0, settled = 0;
    double highest = 0, most_swell = 0;
    RandomBody debris(4);
    for (int n = 0; n < pieces; ++n) {
        const Body inertia = debris.inertia(1000);
        const V d = debris.direction();
        V w = d, p = d;
        double most = 0, most_passive = 0;
        for (int i = 0; i < 600; ++i) {
            w = implicit_gyroscopic.step(inertia, w, 1.0), p = passive_gyroscopic.step(inertia, p, 1.0);
            most = std::max(most, kinetic_energy(inertia, w)),
            most_passive = std::max(most_passive, kinetic_energy(inertia, p));
        }
        for (int i = 600; i < 3000; ++i) p = passive_gyroscopic.step(inertia, p, 1.0);
        const double about = inertia.momentum(p).squaredNorm() / (2 * kinetic_energy(inertia, p));
        settled += about > 0.99 * inertia.moments.maxCoeff();
        const double E0 = kinetic_energy(inertia, d);
        most_swell = std::max(most_swell, swell(inertia, d));
        above += most > 1.01 * E0, above_passive += most_passive > 1.01 * E0, highest = std::max(highest, most / E0);
    }
    std::printf("  of %d pieces of debris at h|omega| = 1, %d ever gain a hundredth (passive: %d)\n", pieces, above,
                above_passive);
    out.number("debris_share", 100.0 * above / pieces, "%",
               "pieces of debris that ever gain a hundredth by one Newton step", 2);
    out.number("debris_highest", highest, "", "the most that any of them gained");
    std::printf("  by the passive step %d of them end about their largest moment\n", settled);
    out.number("pieces", pieces, "", "pieces of debris");
    out.check("passive_settles", settled == pieces,
              "passive: after 3000 steps every piece turns about its largest moment, to a hundredth");
    std::printf("  as they tumble, exactly, |omega| rises by up to x %.2f\n", most_swell);
    const double calm = first / most_swell;
    out.number("calm", calm, "", "h|omega| from which a tumbling piece may come to a gain", 2);
    out.number("calm_spin", calm / settings.step, "rad/s", "the spin that this is", 2);
    out.number("swell", most_swell, "", "the most that |omega| of a piece rises as it tumbles", 2);
    out.check("swell", most_swell > 1.2 && most_swell < std::sqrt(2),
              "as a free body tumbles, its |ω| rises by more than a fifth, by less than √2");
    out.check("debris", above > 0 && above_passive == 0,
              "some pieces gain with one Newton step, none with the passive step");

    // The remedy, in float and double, over all sizes; the energy in double.
    double over = 0, least_momentum = 1;
    RandomBody anything(5);
    const int tried = 60000;
    for (int n = 0; n < tried; ++n) {
        const Body inertia = anything.inertia(1e6);
        const V d = anything.direction();
        const double size = std::pow(10.0, -3 + 9.0 * (n % 1000) / 999);
        over = std::max(over, (gain(passive_gyroscopic, inertia, d, size) - 1) / 2.220446049250313e-16);
        const V next = passive_gyroscopic.step(inertia, d, size);
        least_momentum = std::min(least_momentum, inertia.momentum(next).norm() / inertia.momentum(d).norm());
        const PrincipalInertia<float> rough = rounded(inertia);
        const Body same(rough.moments.x(), rough.moments.y(), rough.moments.z());
        const Vector3<float> f = d.cast<float>();
        const V before = f.cast<double>(), after = passive_gyroscopic.step(rough, f, float(size)).cast<double>();
        over = std::max(over, (kinetic_energy(same, after) / kinetic_energy(same, before) - 1) / 1.1920928955078125e-7);
    }
    std::printf(
        "  passive, %d bodies, h|omega| from 1e-3 to 1e6, float and double:\n"
        "    E' < E (1 + %.1f eps)\n",
        tried, std::max(over, 0.0));
    // L₂ = L₁ + h L₁ × ω₂: the second part is at right angles to the first. Of its rounding, some ε
    // of h|ω₂||L₁|, little is along L₁; for long steps a part in a million is a generous bound.
    out.check("passive_momentum", least_momentum > 1 - 1e-6,
              "the passive step never takes from the angular momentum's length");
    out.number("passive_bodies", tried, "", "bodies that have taken a passive step, in float and in double");
    out.number("passive_over", std::max(over, 0.0), "ε", "the most that a passive step added, in units of roundoff", 2);
    out.check("passive_never_gains", over <= 8,
              "none of these passive steps added more energy than eight units of roundoff");
}
