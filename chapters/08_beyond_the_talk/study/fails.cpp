// Where the half-step Jacobian is singular, what it does there, and what to do then.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>

#include "random_body.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

// The energy after `parts` steps that make up a time of one, over the energy before; |ω| = size.
template <class Solver>
double gain(const Solver& solver, const Body& inertia, const Vector& direction, double size,
            long parts = 1) {
    Vector w = size * direction;
    const double E = kinetic_energy(inertia, w);
    for (long n = 0; n < parts; ++n) w = solver.step(inertia, w, 1 / double(parts));
    const double g = kinetic_energy(inertia, w) / E;
    return std::isfinite(g) ? g : INFINITY;
}

// The same for a method of the whole body: in `steps` steps of one second each.
double whole_gain(const Method& method, const Body& inertia, const Vector& omega, long steps = 1) {
    const Steps steps_of = method.made(inertia);
    Spin s = spinning(omega);
    double most = 0;
    for (long n = 0; n < steps; ++n) {
        s = steps_of(s, 1.0, 1);
        most = larger(most, kinetic_energy(inertia, s.omega));
    }
    return most / kinetic_energy(inertia, omega);
}

// How far E/Δ strays in 100 steps of one second each, over that at the start. With ω_r about the
// axis of the middle moment Δ = 1 − (h/2)² (I_q − I_r)(I_r − I_p)/(I_p I_q) ω_r². By the triangle
// rule the fraction is at most one. So E/Δ stays means: E is at most E₁/Δ₁, for ever.
double strays(const Body& inertia, Vector omega) {
    const auto E_by_D = [&] {
        int r = 0;
        for (int i = 1; i < 3; ++i)
            if (inertia.ratio[(i + 1) % 3] * inertia.ratio[(i + 2) % 3] > 0) r = i;
        const double fraction = inertia.ratio[(r + 1) % 3] * inertia.ratio[(r + 2) % 3];
        return kinetic_energy(inertia, omega) / (1 - fraction * omega[r] * omega[r] / 4);
    };
    const double start = E_by_D();
    double most = 0;
    for (int n = 0; n < 100; ++n) {
        omega = half_step_jacobian.step(inertia, omega, 1.0);
        most = larger(most, std::fabs(E_by_D() / start - 1));
    }
    return most;
}

// The most energy in ten minutes of steps that are 1/60 or 1/120 s, at random, over that at the
// start. With `ask` the passive step is taken wherever h|ω| is above one half.
double gain_of_varying_steps(const Body& inertia, Vector omega, bool ask) {
    std::mt19937 random(11);
    const double start = kinetic_energy(inertia, omega);
    double most = start;
    for (int n = 0; n < 36000; ++n) {
        const double h = random() % 2 == 0 ? 1.0 / 60 : 1.0 / 120;
        omega = ask && h * omega.norm() > 0.5 ? passive_gyroscopic.step(inertia, omega, h)
                                              : half_step_jacobian.step(inertia, omega, h);
        most = larger(most, kinetic_energy(inertia, omega));
    }
    return most / start;
}

// The least h|ω|, in twentieths, at which a plate that is spun about its short axis turns over.
double plate_turns_over(const Method& method) {
    const Steps steps_of = method.made(box(1.0, 2.0, 1.0, 0.1));
    for (double size = 1; size < 10; size += 0.05) {
        Spin s = spinning(size * Vector(1e-3, 1e-3, 1).normalized());
        for (int n = 0; n < 1000; ++n) {
            s = steps_of(s, 1.0, 1);
            if (s.omega.z() < 0) return size;
        }
    }
    return INFINITY;
}

// What |L| allows: |L|²/2I of the least moment, over the energy.
double bound(const Body& inertia, const Vector& omega) {
    const double L = inertia.momentum(omega).norm();
    return L * L / (2 * inertia.moments.minCoeff()) / kinetic_energy(inertia, omega);
}

std::string words(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

void fails(const Settings& settings, lab::Findings& out) {
    out.section("Where the half-step Jacobian fails");
    const Method &strang = method("strang"), &remainder_2 = method("remainder_2"),
                 &remainder_4 = method("remainder_4");
    // Moments 3:2:1 about the middle axis: 1 − (h/2)² a₃a₁ ω² is zero at hω = 2/√(a₃a₁) = 2√3.
    const Body plank(3, 2, 1);
    const double singular = 2 / std::sqrt(-plank.ratio.x() * -plank.ratio.z());
    const Vector middle(1e-3, 1, 1e-3);
    const double there = gain(half_step_jacobian, plank, middle, singular * (1 - 1e-6));
    out.number("singular_at", singular, "", "h|omega| at which the Jacobian of 3:2:1 is singular");
    out.number("singular_gain", 1e5 * std::round(there / 1e5), "",
               "what a step there multiplies the energy by");
    out.check("singular", there > 1e3,
              "at its singular spin a step multiplies the energy without limit");
    std::printf("  moments 3:2:1, middle axis, h|omega| = %.3f: energy x %.1g\n", singular, there);

    auto& curve = out.table("fails.tsv", {"size", "implicit", "half_step", "cayley", "passive",
                                          "substeps", "strang", "remainder_2", "remainder_4"});
    auto& table = out.table("fails_table.tsv",
                            {"$h\\lvert\\omega\\rvert$", "talk", "half-step", "in substeps",
                             "Cayley, passive", "Strang", "ball + rem. 2", "ball + rem. 4"});
    const int many = 4000;
    const double calm = 0.5;  // h|ω| of a substep
    RandomBody bodies(2);
    bool cayley_never = true, bounded = true, splits_gain = false;
    double calm_worst = 0, first = 0, worst_of_strang = 0, worst_of_2 = 0, astray = 0;
    for (int i = -4; i <= 12; ++i) {
        const double size = std::pow(10.0, i / 8.0);
        const long parts = std::lround(std::ceil(size / calm));
        int talk = 0, half = 0, cayley = 0, passive = 0, substeps = 0;
        int takes = 0, strangs = 0, second = 0, fourth = 0, later = 0;
        for (int n = 0; n < many; ++n) {
            const Body inertia = bodies.inertia(1000);
            const Vector d = bodies.direction();
            const double by_talk = gain(implicit_gyroscopic, inertia, d, size);
            talk += by_talk > 1.5, takes += by_talk < 0.5;
            half += gain(half_step_jacobian, inertia, d, size) > 1.5;
            cayley += gain(cayley_gyroscopic, inertia, d, size) > 1 + 1e-12;
            passive += gain(passive_gyroscopic, inertia, d, size) > 1 + 1e-12;
            const double g = gain(half_step_jacobian, inertia, d, size, parts);
            substeps += g > 1.5;
            if (i == 2) astray = larger(astray, strays(inertia, size * d));
            calm_worst = std::max(calm_worst, i <= 8 ? g : 0);
            const Vector w = size * d;
            const double by_strang = whole_gain(strang, inertia, w),
                         by_2 = whole_gain(remainder_2, inertia, w),
                         by_4 = whole_gain(remainder_4, inertia, w);
            const double most = std::max({by_strang, by_2, by_4});
            bounded = bounded && most <= bound(inertia, w) * (1 + 1e-12);
            strangs += by_strang > 1.5, second += by_2 > 1.5, fourth += by_4 > 1.5;
            if (i != 8) continue;
            worst_of_strang = std::max(worst_of_strang, by_strang);
            worst_of_2 = std::max(worst_of_2, by_2);
            const double in_time = whole_gain(remainder_2, inertia, w, 100);
            bounded = bounded && in_time <= bound(inertia, w) * (1 + 1e-12);
            later += in_time > 1.5;
        }
        const auto share = [&](int of) { return double(of) / many; };
        curve.row({size, share(talk), share(half), share(cayley), share(passive), share(substeps),
                   share(strangs), share(second), share(fourth)});
        const auto of_all = [&](int of) {
            return of == 0 ? "none" : words("%.2g %%", 100 * share(of));
        };
        if (i >= 0 && (i % 4 == 0 || i == 2))
            table.row({words("%.2g", size), of_all(talk), of_all(half), of_all(substeps),
                       of_all(cayley + passive), of_all(strangs), of_all(second), of_all(fourth)});
        if (i == 12) out.number("talk_takes", 100 * share(takes), "%",
                                "bodies that keep less than half by the talk's at the right end", 2);
        cayley_never = cayley_never && cayley == 0 && passive == 0;
        if (first == 0 && half > 0) first = size;
        if (i == 8) {
            out.number("fails_at_10", 100 * share(half), "%",
                       "bodies that gain half of their energy or more at h|omega| = 10", 2);
            out.check("fails_at_10", share(half) > 0.25 && share(half) < 0.4,
                      "at h|ω| = 10 the half-step Jacobian multiplies the energy of about a third "
                      "of random bodies by more than 1.5");
            std::printf("  h|omega| = 10: %.0f %% of %d random bodies gain half or more\n",
                        100 * share(half), many);
            std::printf(
                "  by Strang %.0f %%, by ball and remainder 2 %.0f %%, in 100 of its steps %.0f %%\n",
                100 * share(strangs), 100 * share(second), 100 * share(later));
            out.number("splits_strang", 100 * share(strangs), "%",
                       "bodies that gain half by one step of Strang at h|omega| = 10", 2);
            out.number("splits_remainder_2", 100 * share(second), "%",
                       "and by one of ball and remainder 2", 2);
            out.number("splits_remainder_4", 100 * share(fourth), "%",
                       "and by one of ball and remainder 4", 2);
            out.number("splits_later", 100 * share(later), "%",
                       "and at any time in 100 steps of ball and remainder 2", 2);
            splits_gain = share(strangs) > 0.3 && share(second) > 0.05 && share(later) > 0.5;
        }
    }
    out.number("splits_strang_most", 10 * std::round(worst_of_strang / 10), "",
               "Strang's worst gain there");
    out.number("splits_remainder_2_most", worst_of_2, "", "that of ball and remainder 2", 2);
    out.check("splits_gain", splits_gain,
              "at h|ω| = 10 splittings add energy: half or more to over 30 % of random bodies in "
              "a step of Strang, to over 5 % in one of ball and remainder 2, to over 50 % in 100");
    out.check("splits_bounded", bounded,
              "no splitting brings the energy above |L|²/2I of the least moment");
    const Body ruler = box(0.05, 1.0, 0.1, 0.02);
    double varying = 0, asked = 0;
    const int throws = 20;
    for (int n = 0; n < throws; ++n) {
        const Vector omega = 30 * bodies.direction();
        varying = larger(varying, gain_of_varying_steps(ruler, omega, false));
        asked = larger(asked, gain_of_varying_steps(ruler, omega, true));
    }
    std::printf("  a ruler, steps of 1/60 and 1/120 s at random: energy up to x %.2g,\n"
                "  with h|omega| asked in each x %.3g\n", varying, asked);
    out.number("varying_gain", std::pow(10, std::floor(std::log10(varying))), "",
               "the most energy of a ruler, steps that vary, over its first, rounded down");
    out.number("varying_throws", throws, "", "throws of the ruler, steps that vary");
    out.number("asked_gain", asked, "", "a ruler, steps that vary, h|omega| asked in each", 3);
    out.check("varying", varying > 2,
              "with steps of 1/60 and 1/120 s at random a ruler at 30 rad/s at some time has more "
              "than twice its energy by the half-step Jacobian");
    out.check("varying_asked", asked < 1.5,
              "where h|ω| is asked in every step, and passive taken above 0.5, none of these throws has 1.5 times");
    const double plate_2 = plate_turns_over(remainder_2), plate_4 = plate_turns_over(remainder_4);
    out.number("plate_2", plate_2, "",
               "h|omega| at which a plate turns over by ball and remainder 2", 2);
    out.number("plate_4", plate_4, "", "the same by ball and remainder 4", 2);
    out.check("plate", plate_2 > 2 && plate_2 < 2.5 && plate_4 > 2 * plate_2 && plate_4 < 10,
              "a plate spun about its short axis turns over by ball and remainder 2 from h|ω| "
              "between 2 and 2.5 on, by ball and remainder 4 later");
    const double half_more = 2 / std::sqrt(3.0);  // h|ω| where the bound is 1.5
    const double calm_bound = 1 / (1 - calm * calm / 4);
    out.number("fails_below", half_more, "", "h|omega| below which no body ever gains half");
    out.number("fails_below_spin", half_more / settings.step, "rad/s", "the spin that this is", 2);
    out.number("fails_many", many, "", "random bodies a point");
    out.number("calm", calm, "", "h|omega| of a substep");
    out.number("calm_gain", calm_bound, "",
               "gain of the half-step Jacobian in such substeps, at most", 3);
    out.check("fails_bound", astray < 1e-9,
              "the half-step Jacobian keeps E/Δ to roundoff, 100 steps at h|ω| = 1.8");
    out.check("fails_first", first > half_more,
              "below h|ω| = 2/√3 no random body gains half of its energy");
    out.check("cayley_never", cayley_never,
              "the Cayley step and the passive step add energy to none, at any h|ω|");
    out.check("calm", calm_worst <= calm_bound,
              "in substeps of h|ω| = 0.5 none gains more than 1/(1 − 1/16) of its energy");
    std::printf("  the first at h|omega| = %.2g; in substeps of %.1f at most x %.3f\n", first, calm,
                calm_worst);
}
