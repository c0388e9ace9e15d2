// The Dzhanibekov effect: a box spun about its middle axis turns over, again and again.

#include <cmath>
#include <cstdio>

#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;

V in_body(const RigidState<double>& s) { return s.q.conjugate() * s.omega; }

// The times at which the spin about the middle axis changes its sign.
struct Flips {
    std::vector<double> at;
    double t = 0, y = 0;
    void see(double time, double spin) {
        if (y * spin < 0) at.push_back(t + (time - t) * y / (y - spin));
        t = time, y = spin;
    }
};

std::string words(const char* format, double value) {
    char text[400];
    std::snprintf(text, sizeof text, format, value);
    return text;
}
std::string words(const std::vector<double>& at) {
    std::string list;
    for (std::size_t i = 0; i < at.size() && i < 4; ++i) list += (i ? ", " : "") + words("%.2f", at[i]);
    return at.empty() ? "no time" : list + (at.size() > 4 ? ", …" : "");
}

// What the passive step makes of the box with a step so short.
struct Shorter {
    double energy = 1;
    std::size_t changes = 0;
};
Shorter passive_with(double h, const PrincipalInertia<double>& brick, const RigidState<double>& start, double seconds) {
    Flips seen;
    Shorter result;
    const double E0 = kinetic_energy(brick, start);
    spin_on(solver("passive"), brick, start, h, std::lround(seconds / h), [&](const RigidState<double>& s) {
        seen.see(s.t, in_body(s).y());
        result = {kinetic_energy(brick, s) / E0, seen.at.size()};
        return true;
    });
    return result;
}

}  // namespace

void tumble(const Settings& settings, lab::Findings& out) {
    out.section("A box turns over");
    const double mass = 1;
    const auto brick = box(mass, 1.0, 2.0, 3.0);
    const auto start = spinning(settings.tilt, settings.spin, settings.tilt);
    const ExactFreeBody<double> exact(brick, start);
    const double E0 = kinetic_energy(brick, start), L0 = angular_momentum(brick, start).norm();
    const double seconds = 12, h = settings.step;

    auto& table = out.table("tumble_exact.tsv", {"t", "x", "y", "z", "energy", "momentum"});
    Flips truth;
    for (int i = 0; i <= 2400; ++i) {
        const V w = in_body(exact(i * 0.005));
        truth.see(i * 0.005, w.y());
        table.row({i * 0.005, w.x(), w.y(), w.z(), 1.0, 1.0});
    }
    auto& flips =
        out.table("flips.tsv", {"solver", "middle component changes sign at (s)", "energy left", "momentum left"});
    flips.row({std::string("exact"), words(truth.at), std::string("1"), std::string("1")});
    std::printf("  %-24s middle spin changes sign at (s) energy left\n", "");
    std::printf("  %-24s %s\n", "exact", words(truth.at).c_str());
    const bool turns = !truth.at.empty();
    out.number("tumble_first", turns ? truth.at[0] : 0, "s", "when the box first turns over, exactly");
    out.number("tumble_between", truth.at.size() > 1 ? truth.at[1] - truth.at[0] : 0, "s",
               "from flip to flip, exactly");
    out.number("tumble_seconds", seconds, "s", "length of the run");
    out.number("tumble_spin", settings.spin, "rad/s", "spin about the intermediate axis");
    out.number("tumble_tilt", settings.tilt, "rad/s", "spin about the other two");
    out.number("tumble_mass", mass, "kg", "mass of the box");
    const V I = brick.moments;
    char moments[80];
    std::snprintf(moments, sizeof moments, "(%.3g, %.3g, %.3g) kg m²", I.x(), I.y(), I.z());
    out.text("tumble_moments", moments, "its moments about x, y and z");
    out.number("tumble_moment", L0 * L0 / E0 / 2, "kg m²", "L²/2E, exactly");

    for (const Solver& solver : solvers()) {
        const std::string id = "tumble_" + solver.key;
        auto& run = out.table(id + ".tsv", {"t", "x", "y", "z", "energy", "momentum"});
        Flips seen;
        double energy = 1, momentum = 1, most = 1, last = 0;
        spin_on(solver, brick, start, h, std::lround(seconds / h), [&](const RigidState<double>& s) {
            const V w = in_body(s);
            energy = kinetic_energy(brick, s) / E0, momentum = angular_momentum(brick, s).norm() / L0;
            if (!is_finite(s) || !(energy < 1e6)) return false;
            most = std::max(most, energy), last = s.t;
            seen.see(s.t, w.y());
            run.row({s.t, w.x(), w.y(), w.z(), energy, momentum});
            return true;
        });
        const double about = momentum * momentum / energy * (L0 * L0 / E0 / 2);  // L²/2E, a moment
        const bool burst = last < seconds - h;
        const std::string times = words(seen.at);
        const int pad = times.find("…") == std::string::npos ? 31 : 33;  // "…" is three bytes
        std::printf("  %-24s %-*s %s\n", solver.name.c_str(), pad, times.c_str(),
                    burst ? words("a million at %.2f s", last + h).c_str() : words("%.4g", energy).c_str());
        flips.row({solver.name, words(seen.at),
                   burst ? words("blown up after %.2f s", last + h) : words("%.3g", energy),
                   burst ? std::string("–") : words("%.3g", momentum)});
        out.number(id + "_moment", about, "kg m²", "L²/2E at the end: the moment about which it turns");
        const std::string& k = solver.key;
        if (k == "explicit") {
            double burst_at = -1;
            spin_on(solver, brick, start, h, std::lround(120 / h), [&](const RigidState<double>& s) {
                if (!(kinetic_energy(brick, s) < 1e6 * E0)) burst_at = s.t;
                return burst_at < 0;
            });
            out.number("tumble_blow_up", burst_at, "s", "until explicit has a million times the energy");
            out.check("tumble_explicit", energy > 1.2 && burst_at > 0,
                      "explicit: the box gains a fifth of its energy and more within the run, and a "
                      "millionfold later");
        } else if (k == "dropped") {
            out.check("tumble_dropped", seen.at.empty(), "without the term the box never turns over");
        } else if (k == "implicit" || k == "passive" || k == "converged") {
            out.check(id, turns && !seen.at.empty() && energy < 1 && most < 1 + 1e-9,
                      solver.name + ": the box turns over, and its energy sinks");
            // The tilt grows to the spin like e^(σt), σ² = ω²(I₁ − I₂)(I₂ − I₃)/(I₁I₃). Implicit
            // Euler multiplies it by 1/(1 − hσ) a step: the share hσ/2 too fast, and less as the
            // tilt grows. The passive step takes L from the old state, and is some of h|ω| too
            // slow.
            const double sigma = settings.spin * std::sqrt((I.x() - I.y()) * (I.y() - I.z()) / (I.x() * I.z()));
            const double early = turns && !seen.at.empty() ? 1 - seen.at[0] / truth.at[0] : 1;
            if (k == "passive")
                out.check(id + "_time", early < 0 && -early < h * settings.spin,
                          "passive: the first flip is late, by less than the share h|ω|");
            else
                out.check(id + "_time", early > 0 && early < h * sigma / 2,
                          solver.name + ": the first flip is early, by less than the share hσ/2 of its time");
            const bool all = truth.at.size() > 1 && seen.at.size() == truth.at.size();
            double off = 0;
            for (std::size_t i = 0; all && i < seen.at.size(); ++i)
                off = std::max(off, std::fabs(seen.at[i] - truth.at[i]));
            if (k == "implicit") {
                out.number("tumble_implicit_off", off, "s", "the largest error of its flips", 2);
                // As early as the first: what a flip starts from is what the last one left.
                out.check("tumble_implicit_keeps_time", all && off < h * sigma / 2 * truth.at[0],
                          "one Newton step has all flips, each early or late by less than the share "
                          "hσ/2 of the time to the first");
            }
            if (k == "passive") {
                out.number("tumble_passive_flips", double(seen.at.size()), "",
                           "passive: how often the middle component changes sign");
                out.number("tumble_exact_flips", double(truth.at.size()), "", "how often the box turns over, exactly");
                out.check("tumble_passive_hurries", seen.at.size() > 2 * truth.at.size(),
                          "passive: the middle component changes its sign more than twice as often "
                          "as it should");
                const Shorter quarter = passive_with(h / 4, brick, start, seconds),
                              short_steps = passive_with(h / 64, brick, start, seconds);
                std::printf("  %-24s %zu times %23s%.4g\n", "passive, h/4", quarter.changes, "", quarter.energy);
                std::printf("  %-24s %zu times %23s%.4g\n", "passive, h/64", short_steps.changes, "",
                            short_steps.energy);
                out.number("tumble_quarter_energy", quarter.energy, "",
                           "passive with a quarter of the step: energy left");
                out.number("tumble_short_flips", double(short_steps.changes), "",
                           "passive with a 64th of the step: how often the component changes sign");
                out.check("tumble_shorter",
                          std::fabs(quarter.energy - energy) < 0.01 && short_steps.changes > truth.at.size(),
                          "passive: a quarter of the step ends at the same energy, and a 64th still "
                          "changes sign too often");
            }
        }
    }
}
