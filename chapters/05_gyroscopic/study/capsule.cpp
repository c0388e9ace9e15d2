// Bodies with two equal moments, or nearly so, thrown and left alone: a capsule and a slender
// staff.

#include <cmath>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;

// The body's long axis in the world.
V axis(const RigidState<double>& s) { return s.q * V(V::UnitZ()); }

double turn_rate(const RigidState<double>& a, const RigidState<double>& b, const V& about) {
    const V u = axis(a) - about * about.dot(axis(a)), v = axis(b) - about * about.dot(axis(b));
    return std::atan2(about.dot(u.cross(v)), u.dot(v)) / (b.t - a.t);
}

// The passive step's ω after a second, where two moments are equal: the exact one turns about the
// axis.
double order_of_round(const Round& pill) {
    const double angle = pill.precession_ratio * 20;  // that it turns by
    std::vector<double> h, error;
    for (long steps = 120; steps <= 960; steps *= 2) {
        V omega(5, 0, 20);
        for (long n = 0; n < steps; ++n) omega = passive_gyroscopic.step(pill, omega, 1.0 / double(steps));
        h.push_back(1.0 / double(steps));
        error.push_back((omega - V(5 * std::cos(angle), 5 * std::sin(angle), 20)).norm());
    }
    return measured_order(h, error);
}

}  // namespace

void free_capsule(const Settings& settings, lab::Findings& out) {
    out.section("A capsule spins in the air");
    const auto pill = capsule(1.0, 0.15, 0.6);
    const auto start = spinning(5, 0, 20);
    const double h = settings.step, seconds = 10;
    const double E0 = kinetic_energy(pill, start);
    const V L0 = angular_momentum(pill, start);
    const double order = order_of_round(pill);
    out.number("passive_round_order", std::round(order), "", "order of passive's ω, two moments equal");
    out.check("passive_round_order", std::fabs(order - 4) < 0.05,
              "with two equal moments passive's ω is of order four");
    std::printf("  I = %.4f across and %.4f along, omega = (5, 0, 20) rad/s, %g s\n", pill.across, pill.along, seconds);
    std::printf("  (a run ends when it has a thousand times its energy)\n");
    std::printf("                               energy     |L|   L turned by   E > 1000 E0 at\n");
    for (const Solver& solver : solvers()) {
        auto& table = out.table("capsule_" + solver.key + ".tsv", {"t", "energy", "momentum", "turned"});
        double most = 0, least = 1, off = 0, late = -1, energy = 1, length = 1;
        double moved = 0;
        spin_on(solver, pill, start, h, std::lround(seconds / h), [&](const RigidState<double>& s) {
            const V L = angular_momentum(pill, s);
            energy = kinetic_energy(pill, s) / E0, length = L.norm() / L0.norm();
            const double turned = std::atan2(L.cross(L0).norm(), L.dot(L0)) * 180 / pi;
            most = std::max(most, energy), least = std::min(least, energy);
            off = std::max(off, turned);
            moved = std::max(moved, (s.omega - start.omega).norm() / start.omega.norm());
            if (late < 0 && energy > 1000) late = s.t;
            table.row({s.t, energy, length, turned});
            return late < 0;
        });
        char when[24] = "never";
        if (late > 0) std::snprintf(when, sizeof when, "%.2f s", late);
        std::printf("  %-25s %10.4g %7.4g %9.1f deg   %s\n", solver.name.c_str(), energy, length, off, when);
        const std::string id = "capsule_" + solver.key;
        out.number(id + "_energy", energy, "", "kinetic energy at the end over that at the start");
        out.number(id + "_momentum", length, "", "|L| at the end over that at the start");
        out.number(id + "_turned", off, "°", "the farthest that its angular momentum turned");
        if (solver.key == "explicit") {
            out.number("capsule_blow_up", late, "s", "until explicit has a thousand times the energy");
            out.check("capsule_explicit_blows_up", late > 0,
                      "with the explicit term the capsule's energy passes a thousandfold");
        } else if (solver.key == "dropped") {
            // Into the body's axes and back: two products with a matrix a step, each good to some 4
            // ε.
            const double roundoff = 8 * 2.2e-16 * seconds / h;
            out.check("capsule_dropped_still", moved < roundoff,
                      "without the term ω stands still in the world, to roundoff");
            out.check("capsule_dropped_momentum", off > 30,
                      "without the term the angular momentum swings by more than 30 degrees");
        } else if (solver.key == "lagged_inertia") {
            // L is rotated there and back each step: some ε of it a step.
            out.check("capsule_old_momentum", off < 1e-6, "with the lagged inertia the angular momentum stays");
            out.check("capsule_old_energy", energy > 1.5,
                      "with the lagged inertia the capsule ends with more than 1.5 times its energy");
        } else if (solver.key == "passive") {
            // A step keeps the energy to 8 ε, and going into the body's axes and back to as much
            // again. In n steps such errors add up like √n: to some 16 ε √600 = 9e-14 here, if they
            // do not conspire.
            out.check("capsule_passive_keeps", std::fabs(most - 1) < 1e-12 && least > 1 - 1e-12,
                      "the passive step keeps a symmetric body's energy, to 1e-12 of it");
        } else {
            out.check(id + "_no_gain", most < 1 + 1e-12 && energy < 0.9,
                      solver.name + ": the capsule is given no energy, and loses more than a tenth of it");
        }
    }
    out.number("capsule_seconds", seconds, "s", "length of the capsule's run");
    out.text("capsule_size", "0.9 m long and 0.3 m thick", "the capsule");
    out.text("capsule_start", "(5, 0, 20) rad/s", "its spin at the start, the last along its axis");
}

// The same capsule, its moments across not quite equal; and with equal ones in the type that does
// not know that they are.
void uneven_capsule(const Settings& settings, lab::Findings& out) {
    out.section("A spin about the length");
    const auto pill = capsule(1.0, 0.15, 0.6);
    // By how much the step for two equal moments turns ω, where the exact motion turns it by θ.
    const auto turned = [&](double theta) {
        const V omega = passive_gyroscopic.step(pill, V(1, 0, theta / pill.precession_ratio), 1.0);
        return std::atan2(omega.y(), omega.x());
    };
    bool falls = true;  // with p = θ²/12 the tangent θ/2 / (1 − p + p²) is largest at p = (1 +
                        // √13)/6: θ = 3.03
    for (const double theta : {3.1, 3.5, 4.0, 6.0, 10.0, 30.0, 100.0})
        falls = falls && turned(1.01 * theta) < turned(theta) && turned(theta) > 0;
    out.number("symmetric_turn_2", 100 * (1 - turned(2) / 2), "%",
               "by which passive turns ω too little, two equal moments, at two radians", 2);
    out.check("symmetric_turn_falls", falls,
              "with two equal moments passive turns ω less, the faster the body spins, from three "
              "radians a step on");
    const auto start = spinning(0.5, 0, 20);
    const double h = settings.step, seconds = 10;
    out.text("uneven_start", "(0.5, 0, 20) rad/s", "spin at the start, the last along the length");
    out.number("uneven_seconds", seconds, "s", "length of these runs");
    std::printf("  omega = (0.5, 0, 20) rad/s, its last component   after 1 s  after %g s\n", seconds);
    struct End {
        double second = 0, spin = 0, energy = 0, momentum = 0, flat = 0;
    };
    const auto after = [&](const Solver& solver, const auto& inertia, double step, const char* what) {
        const double E0 = kinetic_energy(inertia, start), L0 = angular_momentum(inertia, start).norm();
        End end;
        spin_on(solver, inertia, start, step, std::lround(seconds / step), [&](const RigidState<double>& s) {
            const V w = s.q.conjugate() * s.omega;
            if (s.t < 1 + step / 2) end.second = w.z();
            end.spin = w.z(), end.energy = kinetic_energy(inertia, s) / E0;
            end.momentum = angular_momentum(inertia, s).norm() / L0;
            end.flat = std::hypot(w.x(), w.y());
            return true;
        });
        std::printf("  %-23s %-25s %7.2f %10.2f\n", solver.name.c_str(), what, end.second, end.spin);
        return end;
    };
    const double share = 2;  // per cent
    const PrincipalInertia<double> uneven(pill.across, pill.across * (1 + share / 100), pill.along),
        untyped(pill.across, pill.across, pill.along);
    const End passive = after(solver("passive"), uneven, h, "2 % apart");
    const End quarter = after(solver("passive"), uneven, h / 4, "the same, h/4");
    const End implicit = after(solver("implicit"), uneven, h, "2 % apart");
    const End equal = after(solver("passive"), untyped, h, "equal, PrincipalInertia");
    const End typed = after(solver("passive"), pill, h, "equal, SymmetricInertia");
    out.number("uneven_share", share, "%", "by which its moments across differ");
    out.number("uneven_after_second", passive.second, "rad/s",
               "passive: what is left after a second of the spin about the length");
    out.number("uneven_energy", passive.energy, "", "passive: energy left");
    out.number("uneven_momentum", passive.momentum, "", "passive: momentum left");
    out.check("uneven_passive", std::fabs(passive.spin) < 0.1 && passive.flat > 1,
              "passive: a capsule with unequal moments across ends end over end, flat");
    out.check("uneven_quarter", std::fabs(quarter.spin) < 1,
              "passive: with a quarter of the step it does so too, later");
    out.check("uneven_implicit", std::fabs(implicit.spin - 20) < 0.1,
              "one Newton step: the capsule keeps its spin about the length, to 0.1 rad/s");
    out.check("uneven_type", std::fabs(equal.spin) < 0.1 && std::fabs(typed.spin - 20) < 1e-9,
              "passive: equal moments keep that spin as a SymmetricInertia, and lose it as a "
              "PrincipalInertia");
}

void staff(const Settings& settings, lab::Findings& out) {
    out.section("A thrown staff");
    const auto stick = staff(1.0, 2.0, 0.06);
    const auto start = spinning(2, 0, 10);
    const ExactFreeBody<double> exact(PrincipalInertia<double>(stick.across, stick.across, stick.along), start);
    const double h = settings.step;
    const long steps = std::lround(4 / h);
    const V L0 = angular_momentum(stick, start);
    auto& table = out.table("staff_exact.tsv", {"t", "x", "y", "z"});
    for (int i = 0; i <= 400; ++i) {
        const V tip = axis(exact(i * 0.01));
        table.row({i * 0.01, tip.x(), tip.y(), tip.z()});
    }
    // How fast the staff points elsewhere: its axis goes round L in truth, round ω without the
    // term.
    const double truth = turn_rate(exact(0), exact(0.01), L0.normalized());
    const auto path = [&](const Solver& solver) {
        auto& of = out.table("staff_" + solver.key + ".tsv", {"t", "x", "y", "z"});
        double off = 0, miss = 0;
        spin_on(solver, stick, start, h, steps, [&](const RigidState<double>& s) {
            const V L = angular_momentum(stick, s), tip = axis(s);
            off = std::max(off, std::atan2(L.cross(L0).norm(), L.dot(L0)) * 180 / pi);
            miss = std::max(miss, (tip - axis(exact(s.t))).norm());
            of.row({s.t, tip.x(), tip.y(), tip.z()});
            return true;
        });
        std::printf("  %-9s L turns by up to %6.2f deg, the tip is off by up to %.3f m\n", solver.name.c_str(), off,
                    miss);
        out.number("staff_" + solver.key + "_miss", miss, "m", "the farthest that the tip was off");
        return miss;
    };
    const double dropped = path(solver("dropped")), passive = path(solver("passive"));
    const auto after = solver("dropped").turn(stick, start, h);
    const double without = turn_rate(start, after, start.omega.normalized());
    std::printf("  its axis turns with %.2f rad/s in truth, with %.2f rad/s without the term\n", truth, without);
    out.text("staff_size", "2 m long and 0.06 m thick", "the staff");
    out.text("staff_start", "10 rad/s about its length and 2 rad/s across", "its spin at the start");
    out.number("staff_rate", truth, "rad/s", "how fast the staff's axis goes round, exactly");
    out.number("staff_rate_dropped", without, "rad/s", "how fast the staff's axis goes round without the term");
    out.check("staff_spins_too_much", without > 2 * truth,
              "without the term the staff's axis goes round more than twice too fast");
    // Order one: of the half length of 1 m, about half of h|ω| = 0.17.
    out.check("staff_passive_close", passive < 0.1 && dropped > 1,
              "with the passive step the tip stays within 0.1 m of the exact path; without the term "
              "it is off by more than 1 m");
}
