// Where the half-step Jacobian is singular, what it does there, and what to do then.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>

#include "random_body.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

// The energy after a step of one second, over the energy before; |ω| = size.
template <class Solver>
double gain(const Solver& solver, const Body& inertia, const Vector& direction, double size) {
    const Vector w = size * direction;
    const double g = kinetic_energy(inertia, solver.step(inertia, w, 1.0)) / kinetic_energy(inertia, w);
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

// How far E/Δ and |L|²/Δ stray in 100 steps of one second each, over those at the start. With ω_r
// about the axis of the middle moment Δ = 1 − (h/2)² (I_q − I_r)(I_r − I_p)/(I_p I_q) ω_r². By the
// triangle rule the fraction is at most one. So E/Δ stays means: E is at most E₁/Δ₁, for ever.
double strays(const Body& inertia, Vector omega) {
    int r = 0;
    for (int i = 1; i < 3; ++i)
        if (inertia.ratio[(i + 1) % 3] * inertia.ratio[(i + 2) % 3] > 0) r = i;
    const double fraction = inertia.ratio[(r + 1) % 3] * inertia.ratio[(r + 2) % 3];
    const auto D = [&] { return 1 - fraction * omega[r] * omega[r] / 4; };
    const auto E_by_D = [&] { return kinetic_energy(inertia, omega) / D(); };
    const auto L2_by_D = [&] { return inertia.momentum(omega).squaredNorm() / D(); };
    const double E = E_by_D(), L2 = L2_by_D();
    double most = 0;
    for (int n = 0; n < 100; ++n) {
        omega = half_step_jacobian.step(inertia, omega, 1.0);
        most = larger(most, std::fabs(E_by_D() / E - 1));
        most = larger(most, std::fabs(L2_by_D() / L2 - 1));
    }
    return most;
}

// What a game does between the steps: they are 1/60 or 1/120 s, by chance; or always the one after
// which there is more energy; or an impulse every sixth frame, in any direction, that keeps the
// energy.
enum class Frames { by_chance, by_malice, with_impulses };

// The most energy in ten minutes of such frames, over that at the start; and how far off |L| ever
// is.
struct Rough {
    double energy = 1, momentum = 0;
};
template <class Solver>
Rough rough(const Solver& solver, const Body& inertia, Vector omega, Frames frames) {
    RandomBody random(11);
    const auto L = [&] { return inertia.momentum(omega).norm(); };
    const auto E = [&](const Vector& w) { return kinetic_energy(inertia, w); };
    const double start = E(omega), L1 = L();
    Rough most;
    for (int n = 0; n < 36000; ++n) {
        if (frames == Frames::with_impulses && n % 6 == 5) {
            const Vector d = random.direction();
            omega = std::sqrt(E(omega) / E(d)) * d;
        }
        const Vector whole = solver.step(inertia, omega, 1.0 / 60);
        if (frames == Frames::with_impulses) {
            omega = whole;
        } else {
            const Vector half = solver.step(inertia, omega, 1.0 / 120);
            const bool is_half = frames == Frames::by_chance ? random.direction().x() < 0 : E(half) > E(whole);
            omega = is_half ? half : whole;
            most.momentum = larger(most.momentum, std::fabs(L() / L1 - 1));
        }
        most.energy = larger(most.energy, E(omega) / start);
        if (most.energy > 1e12) break;
    }
    return most;
}

// When has a football lost half of the spin about its length? At most after ten minutes.
template <class Solver>
double football_keeps(const Solver& solver, double step) {
    const Body football(1, 1.02, 0.18);
    Vector omega(0.63, 0, 63);
    double t = 0;
    for (; t < 600 && std::fabs(omega.z()) > 63.0 / 2; t += step) omega = solver.step(football, omega, step);
    return t;
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
    const Method &strang = method("strang"), &remainder_2 = method("remainder_2"), &remainder_4 = method("remainder_4");
    // Moments 3:2:1 about the middle axis: 1 − (h/2)² a₃a₁ ω² is zero at hω = 2/√(a₃a₁) = 2√3.
    const Body plank(3, 2, 1);
    const double singular = 2 / std::sqrt(-plank.ratio.x() * -plank.ratio.z());
    const double tilt = 0.01 / singular;
    const Vector middle(tilt, 1, tilt);
    const double there = gain(half_step_jacobian, plank, middle, singular);
    out.number("singular_at", singular, "", "h|omega| at which the Jacobian of 3:2:1 is singular", 5);
    out.number("singular_tilt", tilt * singular, "rad", "h times the spin about each of the other axes");
    out.number("singular_gain", 1e4 * std::round(there / 1e4), "", "what a step there multiplies the energy by");
    out.check("singular", there > 1e3, "at its singular spin a step multiplies the energy without limit");
    std::printf("  moments 3:2:1, intermediate axis, h|omega| = %.3f: energy x %.1g\n", singular, there);

    auto& curve = out.table("fails.tsv", {"size", "implicit", "half_step", "cayley", "passive", "calm", "strang",
                                          "remainder_2", "remainder_4"});
    auto& table =
        out.table("fails_table.tsv", {"$h\\lvert\\omega\\rvert$", "one Newton step", "half-step", "calm half-step",
                                      "Cayley, passive", "Strang", "ball + rem. 2", "ball + rem. 4"});
    const int many = 4000;
    RandomBody bodies(2);
    bool never = true, bounded = true, splits_gain = false, later_and_more = true;
    double first = 0, worst_of_strang = 0, astray = 0;
    for (int i = -4; i <= 12; ++i) {
        const double size = std::pow(10.0, i / 8.0);
        int talk = 0, half = 0, cayley = 0, passive = 0, calm = 0;
        int takes = 0, strangs = 0, second = 0, fourth = 0, later = 0;
        for (int n = 0; n < many; ++n) {
            const Body inertia = bodies.inertia(1000);
            const Vector d = bodies.direction();
            const double by_talk = gain(implicit_gyroscopic, inertia, d, size);
            talk += by_talk > 1.5, takes += by_talk < 0.5;
            half += gain(half_step_jacobian, inertia, d, size) > 1.5;
            cayley += gain(cayley_gyroscopic, inertia, d, size) > 1 + 1e-12;
            passive += gain(passive_gyroscopic, inertia, d, size) > 1 + 1e-12;
            calm += gain(calm_half_step, inertia, d, size) > 1 + 1e-12;
            if (i == 2) astray = larger(astray, strays(inertia, size * d));
            const Vector w = size * d;
            const double by_strang = whole_gain(strang, inertia, w), by_2 = whole_gain(remainder_2, inertia, w),
                         by_4 = whole_gain(remainder_4, inertia, w);
            const double most = std::max({by_strang, by_2, by_4});
            bounded = bounded && most <= bound(inertia, w) * (1 + 1e-12);
            strangs += by_strang > 1.5, second += by_2 > 1.5, fourth += by_4 > 1.5;
            if (i != 8) continue;
            worst_of_strang = std::max(worst_of_strang, by_strang);
            const double in_time = whole_gain(remainder_2, inertia, w, 100);
            bounded = bounded && in_time <= bound(inertia, w) * (1 + 1e-12);
            later += in_time > 1.5;
        }
        const auto share = [&](int of) { return double(of) / many; };
        curve.row({size, share(talk), share(half), share(cayley), share(passive), share(calm), share(strangs),
                   share(second), share(fourth)});
        const auto of_all = [&](int of) { return of == 0 ? "none" : words("%.2g %%", 100 * share(of)); };
        if (i >= 0 && (i % 4 == 0 || i == 2))
            table.row({words("%.2g", size), of_all(talk), of_all(half), of_all(calm), of_all(cayley + passive),
                       of_all(strangs), of_all(second), of_all(fourth)});
        if (i == 12)
            out.number("talk_takes", 100 * share(takes), "%",
                       "bodies that keep less than half by the talk's at the right end", 2);
        if (talk > 0 || half > 0)
            later_and_more = later_and_more && (size < 2.5 ? half < talk : size < 3 || half > talk);
        never = never && cayley == 0 && passive == 0 && calm == 0;
        if (first == 0 && half > 0) first = size;
        if (i == 8) {
            out.number("fails_at_10", 100 * share(half), "%",
                       "bodies that gain half of their energy or more at h|omega| = 10", 2);
            out.check("fails_at_10", share(half) > 0.25 && share(half) < 0.4,
                      "at h|ω| = 10 the half-step Jacobian multiplies the energy of about a third "
                      "of random bodies by more than 1.5");
            std::printf("  h|omega| = 10: %.0f %% of %d random bodies gain half or more\n", 100 * share(half), many);
            std::printf(
                "  by Strang %.0f %%, by ball and remainder 2 %.0f %%, in 100 of its steps %.0f "
                "%%\n",
                100 * share(strangs), 100 * share(second), 100 * share(later));
            out.number("splits_strang", 100 * share(strangs), "%",
                       "bodies that gain half by one step of Strang at h|omega| = 10", 2);
            out.number("splits_remainder_2", 100 * share(second), "%", "and by one of ball and remainder 2", 2);
            out.number("splits_later", 100 * share(later), "%", "and at any time in 100 steps of ball and remainder 2",
                       2);
            splits_gain = share(strangs) > 0.3 && share(second) > 0.05 && share(later) > 0.5;
        }
    }
    out.number("splits_strang_most", 10 * std::round(worst_of_strang / 10), "", "Strang's worst gain there");
    out.check("splits_gain", splits_gain,
              "at h|ω| = 10 splittings add energy: half or more to over 30 % of random bodies in "
              "a step of Strang, to over 5 % in one of ball and remainder 2, to over 50 % in 100");
    out.check("splits_bounded", bounded, "no splitting brings the energy above |L|²/2I of the least moment");
    const Body ruler = box(0.05, 1.0, 0.1, 0.02);
    Rough plain[3], calm[3];  // by chance, by malice, with impulses
    const int throws = 20;
    for (int n = 0; n < throws; ++n) {
        const Vector omega = 30 * bodies.direction();
        for (int i = 0; i < 3; ++i) {
            const Rough a = rough(half_step_jacobian, ruler, omega, Frames(i)),
                        b = rough(calm_half_step, ruler, omega, Frames(i));
            plain[i].energy = larger(plain[i].energy, a.energy);
            calm[i].energy = larger(calm[i].energy, b.energy);
            calm[i].momentum = larger(calm[i].momentum, b.momentum);
        }
    }
    double most = 0, astray_L = 0;
    for (const Rough& r : calm) most = larger(most, r.energy), astray_L = larger(astray_L, r.momentum);
    const auto rounded_down = [](double x) { return std::pow(10, std::floor(std::log10(x))); };
    std::printf(
        "  a ruler, steps of 1/60 and 1/120 s by chance: energy up to x %.0g, with impulses\n"
        "  that keep the energy x %.0g; by the calm half-step 1 + %.0e, |L| off by %.0e\n",
        rounded_down(plain[0].energy), rounded_down(plain[2].energy), most - 1, astray_L);
    out.number("varying_gain", rounded_down(plain[0].energy), "",
               "the most energy of a ruler, steps that vary, over its first, rounded down");
    out.check("varying", plain[0].energy > 2 && plain[1].energy > 2 && plain[2].energy > 1.05,
              "by the half-step Jacobian a ruler at 30 rad/s at some time has more than twice its "
              "energy, "
              "with steps of 1/60 and 1/120 s by chance; and gains between impulses that keep it, too");
    out.check("calm", most < 1 + 1e-9 && astray_L < 1e-9,
              "by the calm half-step it keeps energy and |L| to roundoff for ten minutes, with those "
              "steps by chance and by malice, and the energy with impulses that keep it");
    const double by_passive = football_keeps(passive_gyroscopic, settings.step),
                 by_cayley = football_keeps(cayley_gyroscopic, settings.step),
                 by_calm = football_keeps(calm_half_step, settings.step);
    std::printf(
        "  a football loses half of its spin after %.2g s by passive, %.2g s by Cayley, by the\n"
        "  calm half-step not within %.0f s\n",
        by_passive, by_cayley, by_calm);
    out.number("football_passive", by_passive, "s", "until a football has lost half of its spin, by passive", 2);
    out.number("football_cayley", by_cayley, "s", "the same by Cayley", 2);
    out.check("football", by_passive < 1 && by_cayley < 5 && by_cayley > by_passive && by_calm >= 600,
              "at 63 rad/s a football loses half of its spin within a second by passive, later by "
              "Cayley, "
              "and not within ten minutes by the calm half-step");
    const double plate_2 = plate_turns_over(remainder_2), plate_4 = plate_turns_over(remainder_4);
    out.number("plate_2", plate_2, "", "h|omega| at which a plate turns over by ball and remainder 2", 3);
    out.number("plate_4", plate_4, "", "the same by ball and remainder 4", 3);
    out.check("plate", plate_2 > 2 && plate_2 < 2.5 && plate_4 > 2 * plate_2 && plate_4 < 10,
              "a plate spun about its short axis turns over by ball and remainder 2 from h|ω| "
              "between 2 and 2.5 on, by ball and remainder 4 later");
    const double half_more = 2 / std::sqrt(3.0);  // h|ω| where the bound is 1.5
    out.number("fails_below", half_more, "", "h|omega| below which no body ever gains half");
    out.number("fails_below_spin", half_more / settings.step, "rad/s", "the spin that this is", 2);
    out.number("calm_most", CalmHalfStep::most, "", "substeps of the calm half-step, at most");
    out.check("fails_bound", astray < 1e-9,
              "the half-step Jacobian keeps E/Δ and |L|²/Δ to roundoff, 100 steps at h|ω| = 1.8");
    out.check("fails_first", first > half_more, "below h|ω| = 2/√3 no random body gains half of its energy");
    out.check("fails_later", later_and_more,
              "up to h|ω| = 2.4 the half-step Jacobian gains half on fewer random bodies than one "
              "Newton step, from 3 on more");
    out.check("cayley_never", never, "Cayley, passive and the calm half-step add energy to none, at any h|ω|");
    std::printf("  the first at h|omega| = %.2g\n", first);
}
