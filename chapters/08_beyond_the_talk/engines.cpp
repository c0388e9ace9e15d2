// The appendix: the rules of the engines, and of a few books, each with what it keeps and how it
// fails. The page is docs/rigid_methods.md.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/measured_order.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/tumble.hpp>

#include "engine_body.hpp"

using namespace timestep;
using namespace appendix;

namespace {

std::string rounded(double value, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// The orders of ω and of the attitude, after two seconds of a box with sides 1:2:3.
template <class Method>
std::pair<double, double> orders(const Method& method) {
    const PrincipalInertia<double> I = box(12.0, 1.0, 2.0, 3.0);
    const Spin start = spin_of(2, 1, 2);
    const Spin exact = in_body(ExactFreeBody<double>(I, in_world(start))(2));
    std::vector<double> h, spins, attitudes;
    const long least = method.order == 4 ? 32 : 256;
    for (long steps = least; steps <= 8 * least; steps *= 2) {
        const Spin s = spun(method, I, start, 2.0 / double(steps), steps);
        h.push_back(2.0 / double(steps));
        spins.push_back((s.omega - exact.omega).norm());
        attitudes.push_back((s.q.conjugate() * exact.q).vec().norm());
    }
    return {measured_order(h, spins), measured_order(h, attitudes)};
}

// What a minute at 60 Hz leaves.
struct Left {
    double energy, momentum;  // over those at the start
    double burst;             // s, when the energy has grown a millionfold; 0: never
    double strayed;           // the farthest that the energy was from that at the start, over it
};
template <class Method, class Observe>
Left minute(const Method& method, const PrincipalInertia<double>& I, Spin s,
            const Observe& observe) {
    const double E0 = kinetic_energy(I, s.omega), L0 = I.momentum(s.omega).norm();
    Left left{1, 1, 0, 0};
    for (int n = 0; n <= 3600; ++n) {
        left.energy = kinetic_energy(I, s.omega) / E0;
        left.momentum = I.momentum(s.omega).norm() / L0;
        left.strayed = std::max(left.strayed, std::fabs(left.energy - 1));
        observe(n, left.energy);
        if (!(left.energy < 1e6)) {
            left.burst = n / 60.0;
            break;
        }
        s = method.step(I, s, 1.0 / 60);
    }
    return left;
}

// Three throws of one box, 1 x 2 x 3 m: its moments fall from x to z.
struct Throw {
    const char *key, *about;
    Spin start;
};
const Throw throws[] = {{"middle", "about the middle axis", spin_of(1, 10, 0.1)},
                        {"long", "about the long axis", spin_of(1, 2, 10)},
                        {"short", "about the short axis", spin_of(10, 2, 1)}};

// What the page says of that minute; by the rule's and the throw's key.
void claims(std::map<std::string, Left>& left, lab::Findings& out) {
    bool exact = true, magnus = true, same = true, lost = true, one_length = true, passive = true,
         still = true, bursts = true;
    for (const Throw& thrown : throws) {
        const auto of = [&](const char* rule) {
            return left[std::string(rule) + "_" + thrown.key];
        };
        for (const char* rule : {"implicit_midpoint", "moser_veselov_2", "moser_veselov_4"})
            exact = exact && of(rule).strayed < 1e-11 && std::fabs(of(rule).momentum - 1) < 1e-11;
        magnus = magnus && of("magnus_taylor_4").strayed < 1e-3 &&
                 std::fabs(of("magnus_taylor_4").momentum - 1) < 1e-11;
        same = same && std::fabs(of("bullet").energy / of("mujoco").energy - 1) < 1e-9;
        lost = lost && of("mujoco").energy < 0.98 && of("mujoco").momentum < 1 &&
               of("box3d").energy < 0.98 && of("box3d").momentum < 1;
        one_length = one_length && std::fabs(of("jolt").momentum - 1) < 1e-11;
        passive = passive && of("ode").energy < 1 && of("ode").momentum > 1;
        still = still && of("godot").strayed < 1e-12;
        bursts = bursts && of("explicit_euler").burst > 0;
    }
    out.check("engines_exact", exact,
              "implicit midpoint, Moser-Veselov: energy and |L| stay for a minute, to roundoff");
    out.check("engines_magnus", magnus,
              "Magnus-Taylor: |L| stays to roundoff, and of the energy all but a thousandth");
    out.check("engines_same", same, "Bullet's rule and MuJoCo's are one while no guard acts");
    out.check("engines_lost", lost,
              "one Newton step, and four smaller ones, lose energy and |L| in every throw");
    out.check("engines_lost_half", left["mujoco_middle"].energy < 0.5 &&
                                       left["box3d_middle"].energy < 0.5 &&
                                       left["box3d_middle"].energy > left["mujoco_middle"].energy,
              "thrown about its middle axis the box loses more than half, in four substeps less");
    out.check("engines_jolt_momentum", one_length, "Jolt: |L| stays to roundoff");
    out.check("engines_jolt_loses", left["jolt_long"].energy < 0.9,
              "Jolt: the box loses energy when thrown about its long axis");
    out.check("engines_jolt_gains", left["jolt_short"].energy > 1.1,
              "Jolt: the box gains energy when thrown about its short axis");
    out.check("engines_ode", passive, "ODE: the energy decays, and |L| grows");
    out.check("engines_godot", still, "Godot: the energy stays");
    out.check("engines_burst", bursts, "explicit Euler: every throw blows up within the minute");
}

void a_minute(lab::Findings& out) {
    const PrincipalInertia<double> brick = box(1.0, 1.0, 2.0, 3.0);
    auto& table = out.table("engines_minute.tsv",
                            {"rule", "order of ω", "of the attitude", "middle axis: energy",
                             "momentum", "long axis: energy", "momentum", "short axis: energy",
                             "momentum"});
    std::map<std::string, Left> left_of;
    std::printf("  a minute of a box thrown about its middle, its long and its short axis:\n");
    for_each_other([&](const auto& method) {
        const std::string key = lab::id(method.name);
        const auto [spin, attitude] = orders(method);
        const bool converges = method.order > 0;
        std::vector<lab::Cell> cells{std::string(method.name),
                                     converges ? rounded(spin, "%.1f") : "none",
                                     converges ? rounded(attitude, "%.1f") : "none"};
        std::printf("  %-18s order %4s; energy", method.name,
                    std::get<std::string>(cells[1]).c_str());
        for (const Throw& thrown : throws) {
            const std::string id = key + "_" + thrown.key;
            auto& curve = out.table("engines_" + id + ".tsv", {"t", "energy"});
            const Left left = minute(method, brick, thrown.start, [&](int n, double energy) {
                if (n % 15 == 0) curve.row({n / 60.0, energy});
            });
            left_of[id] = left;
            const bool burst = left.burst > 0;
            const std::string energy = burst ? rounded(left.burst, "blown up after %.1f s")
                                             : rounded(left.energy, "%.3f");
            cells.push_back(energy);
            cells.push_back(burst ? std::string("–") : rounded(left.momentum, "%.3f"));
            std::printf("%s%6s", &thrown == &throws[0] ? "" : ",",
                        burst ? "burst" : energy.c_str());
            if (burst)
                out.number("engines_burst_" + id, left.burst, "s", "until it has blown up");
            else
                out.number("engines_energy_" + id, left.energy, "",
                           "energy after a minute over that at the start");
        }
        table.row(cells);
        std::printf("\n");
        if (converges)
            out.check("engines_order_" + key,
                      std::fabs(spin - method.order) < 0.2 &&
                          std::fabs(attitude - method.order) < 0.2,
                      std::string(method.name) + ": the measured orders are those it claims");
    });
    claims(left_of, out);
    std::string words;
    for (const Throw& thrown : throws) {
        const auto& w = thrown.start.omega;
        words += (words.empty() ? "" : ", ") + std::string("(") + rounded(w.x(), "%g") + ", " +
                 rounded(w.y(), "%g") + ", " + rounded(w.z(), "%g") + ")";
    }
    out.text("engines_throws", "ω = " + words + " rad/s", "middle, long and short axis");
}

// What implicit midpoint pays: Newton steps, and time beside a step of the half-step Jacobian.
void price(lab::Findings& out) {
    const PrincipalInertia<double> I = box(1.0, 1.0, 2.0, 3.0);
    long iterations = 0;
    Spin s = spin_of(1, 10, 0.1);
    for (int n = 0; n < 3600; ++n)
        s = midpoint_spin.step(I, s, 1.0 / 60, [&] { ++iterations; });
    const double each = double(iterations) / 3600;

    const auto seconds = [&](const auto& method) {
        const auto start = std::chrono::steady_clock::now();
        const Spin end = spun(method, I, spin_of(1, 10, 0.1), 1.0 / 60, 20000);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        return end.omega.allFinite() ? time.count() : std::numeric_limits<double>::quiet_NaN();
    };
    double implicit = 1, half_step = 1, veselov = 1;
    for (int round = 0; round < 5; ++round) {  // in turns: a slow moment of the machine hits all
        implicit = std::min(implicit, seconds(midpoint_spin));
        veselov = std::min(veselov, seconds(moser_veselov_2));
        half_step = std::min(half_step, seconds(tumble<HalfStepJacobian>));
    }
    std::printf("  implicit midpoint: %.1f Newton steps a step, %.1f times the time of the\n"
                "  half-step Jacobian (Moser-Veselov: %.1f)\n",
                each, implicit / half_step, veselov / half_step);
    out.number("engines_midpoint_newton", each, "", "Newton steps in a step of implicit midpoint",
               2);
    out.number("engines_midpoint_price", implicit / half_step, "",
               "its time over that of the half-step Jacobian", 2);
    out.number("engines_veselov_price", veselov / half_step, "",
               "Moser-Veselov's time over that of the half-step Jacobian", 2);
    out.check("engines_midpoint_price", each > 2,
              "implicit midpoint: more than two Newton steps in a step of this box");
}

}  // namespace

void engines(lab::Findings& out) {
    out.section("The rules of the engines");
    a_minute(out);
    price(out);
    engines_fail(out);
}
