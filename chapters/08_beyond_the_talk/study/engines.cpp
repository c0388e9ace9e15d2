// The appendix: the rules of the engines, and of a few books, each with what it keeps and how it
// fails. The page is engines/rigid_methods.md.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/measured_order.hpp>
#include <timestep/rigid/shapes.hpp>

#include "engines/midpoint.hpp"
#include "engine_body.hpp"

using namespace timestep;
using namespace appendix;

namespace {

std::string rounded(double value, const char* format) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

// To two digits, as long as that is a plain number.
std::string plain(double value) {
    const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
    return rounded(std::round(value / unit) * unit, "%g");
}

// The orders of ω and of the orientation, after two seconds of a box with sides 1:2:3.
std::pair<double, double> orders(const Method& method) {
    const Body I = box(12.0, 1.0, 2.0, 3.0);
    const Spin start = spin_of(2, 1, 2);
    const Spin exact = Exact(I, start)(2);
    const Steps take = method.made(I);
    std::vector<double> h, spins, orientations;
    const long least = method.order == 4 ? 32 : 256;
    for (long steps = least; steps <= 8 * least; steps *= 2) {
        const Spin s = take(start, 2.0 / double(steps), steps);
        h.push_back(2.0 / double(steps));
        spins.push_back((s.omega - exact.omega).norm());
        orientations.push_back((s.q.conjugate() * exact.q).vec().norm());
    }
    return {measured_order(h, spins), measured_order(h, orientations)};
}

// What a minute at 60 Hz leaves.
struct Left {
    double energy, momentum;  // over those at the start
    double burst;             // s, when the energy has grown a millionfold; 0: never
    double strayed;           // the farthest that the energy was from that at the start, over it
};
Left minute(const Steps& take, const Body& I, Spin s, const std::function<void(int n, double energy)>& observe) {
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
        s = take(s, 1.0 / 60, 1);
    }
    return left;
}

// Three throws of one box, 1 x 2 x 3 m: its moments fall from x to z.
struct Throw {
    const char *key, *about;
    Spin start;
};
const Throw throws[] = {{"short", "short axis", spin_of(10, 2, 1)},
                        {"middle", "intermediate axis", spin_of(1, 10, 0.1)},
                        {"long", "long axis", spin_of(1, 2, 10)}};
const Spin& tumbling = throws[1].start;

// What the page says of that minute; by the rule's and the throw's key.
void claims(std::map<std::string, Left>& left, lab::Findings& out) {
    bool exact = true, magnus = true, buss = true, adams = true, spiers = true, same = true, lost = true,
         one_length = true, passive = true, still = true, bursts = true;
    for (const Throw& thrown : throws) {
        const auto of = [&](const char* rule) { return left[std::string(rule) + "_" + thrown.key]; };
        for (const char* rule : {"implicit_midpoint", "moser_veselov_2", "moser_veselov_4"})
            exact = exact && of(rule).strayed < 1e-11 && std::fabs(of(rule).momentum - 1) < 1e-11;
        magnus =
            magnus && of("magnus_taylor_4").strayed < 1e-3 && std::fabs(of("magnus_taylor_4").momentum - 1) < 1e-11;
        for (const char* rule : {"buss_2", "buss_augmented"})
            buss = buss && of(rule).energy > 1 && of(rule).strayed < 0.1 && std::fabs(of(rule).momentum - 1) < 1e-11;
        adams =
            adams && of("adams_bashforth_2").strayed < 0.1 && std::fabs(of("adams_bashforth_2").momentum - 1) > 1e-3;
        for (const char* rule : {"spiers", "avian_proposed"})
            for (const char* other : {"buss_2", "buss_augmented", "adams_bashforth_2"})
                spiers = spiers && of(rule).strayed < 2e-3 && of(rule).strayed < of(other).strayed &&
                         std::fabs(of(rule).momentum - 1) < 1e-11;
        same = same && std::fabs(of("bullet").energy / of("mujoco").energy - 1) < 1e-9;
        lost = lost && of("mujoco").energy < 0.98 && of("mujoco").momentum < 1 && of("box3d").energy < 0.98 &&
               of("box3d").momentum < 1;
        one_length = one_length && std::fabs(of("jolt").momentum - 1) < 1e-11;
        passive = passive && of("ode").energy < 1 && of("ode").momentum > 1;
        still = still && of("godot").strayed < 1e-12;
        bursts = bursts && of("explicit_euler").burst > 0;
    }
    out.check("engines_exact", exact,
              "implicit midpoint, Moser-Veselov: energy and |L| stay for a minute, to roundoff");
    out.check("engines_magnus", magnus, "Magnus-Taylor: |L| stays to roundoff, and of the energy all but a thousandth");
    out.check("engines_buss", buss, "Buss's steps: |L| stays to roundoff, and the energy grows by less than a tenth");
    out.check("engines_adams", adams, "Adams-Bashforth 2: the energy stays within a tenth, and |L| does not stay");
    out.check("engines_spiers", spiers,
              "Spiers's steps: |L| stays for a minute, to roundoff, and the energy to two "
              "thousandths, nearer "
              "than by Buss's and Adams-Bashforth's");
    out.check("engines_same", same, "Bullet's rule and MuJoCo's are one while no guard acts");
    out.check("engines_lost", lost, "one Newton step, and four smaller ones, lose energy and |L| in every throw");
    out.check("engines_lost_half",
              left["mujoco_middle"].energy < 0.5 && left["box3d_middle"].energy < 0.5 &&
                  left["box3d_middle"].energy > left["mujoco_middle"].energy,
              "thrown about its intermediate axis the box loses more than half, in four substeps less");
    out.check("engines_jolt_momentum", one_length, "Jolt: |L| stays to roundoff");
    out.check("engines_jolt_loses", left["jolt_long"].energy < 0.9,
              "Jolt: the box loses energy when thrown about its long axis");
    out.check("engines_jolt_gains", left["jolt_short"].energy > 1.1,
              "Jolt: the box gains energy when thrown about its short axis");
    out.check("engines_ode", passive, "ODE: the energy decays, and |L| grows");
    out.check("engines_godot", still, "Godot: the energy stays");
    const auto off = [&](const std::string& id) { return std::fabs(left[id].energy - 1); };
    bool seen = off("jolt_short") > 0.2 && off("jolt_middle") < 0.01;
    for (const char* rule : {"box3d", "bullet", "mujoco", "ode"}) {
        const std::string key = rule;
        seen = seen && off(key + "_short") < 0.03 && off(key + "_middle") > 0.1;
    }
    for (const char* rule : {"box3d", "bullet", "mujoco", "ode", "jolt"})
        seen = seen && off(std::string(rule) + "_long") > 0.05;
    out.check("engines_figure", seen,
              "Box3D, Bullet, MuJoCo and ODE lose less than 3 % of the energy about the short "
              "axis, and over 10 % about the middle one; Jolt is off by over 20 % and by less than "
              "1 %; about the long axis all five are off by over 5 %");
    out.check("engines_burst", bursts, "explicit Euler: every throw blows up within the minute");
}

void a_minute(const Body& brick, const std::map<std::string, double>& ns, lab::Findings& out) {
    std::vector<std::string> columns{"rule", "order of ω", "of the orientation", "ns a step"};
    for (const Throw& thrown : throws)
        for (const char* left : {": energy", ": $\\lvert L\\rvert$"})
            columns.push_back(std::string(thrown.about) + left);
    auto& table = out.table("engines_minute.tsv", columns);
    std::set<std::string> printed;
    for (const Method& rule : engines()) printed.insert(rule.key);
    std::map<std::string, Left> left_of;
    std::printf(
        "  energy left of a box thrown about its short, its middle and its long axis,\n"
        "  after a minute at 60 Hz; implicit midpoint, Moser-Veselov and Magnus keep it to a "
        "thousandth:\n");
    for (const Method& method : others()) {
        const std::string& key = method.key;
        const auto [spin, orientation] = orders(method);
        const bool converges = method.order > 0, prints = printed.count(key) > 0;
        std::vector<lab::Cell> cells{method.name, converges ? rounded(spin, "%.1f") : "none",
                                     converges ? rounded(orientation, "%.1f") : "none", plain(ns.at(key))};
        if (prints) std::printf("  %-15s", method.name.c_str());
        for (const Throw& thrown : throws) {
            const std::string id = key + "_" + thrown.key;
            auto& curve = out.table("engines_" + id + ".tsv", {"t", "energy"});
            const auto observe = [&](int n, double energy) {
                if (n % 15 == 0) curve.row({n / 60.0, energy});
            };
            const Left left = minute(method.made(brick), brick, thrown.start, observe);
            left_of[id] = left;
            const bool burst = left.burst > 0;
            const std::string energy =
                burst ? rounded(left.burst, "blown up after %.1f\u00a0s") : rounded(left.energy, "%.3f");
            cells.push_back(energy);
            cells.push_back(burst ? std::string("–") : rounded(left.momentum, "%.3f"));
            if (prints) std::printf("%8s", burst ? "burst" : energy.c_str());
            if (burst)
                out.number("engines_burst_" + id, left.burst, "s", "until it has blown up");
            else
                out.number("engines_energy_" + id, left.energy, "", "energy after a minute over that at the start");
        }
        table.row(cells);
        if (prints) std::printf("\n");
        if (converges)
            out.check("engines_order_" + key,
                      std::fabs(spin - method.order) < 0.2 && std::fabs(orientation - method.order) < 0.2,
                      method.name + ": the measured orders are those it claims");
    }
    claims(left_of, out);
    std::string words;
    for (const Throw& thrown : throws) {
        const auto& w = thrown.start.omega;
        words += (words.empty() ? "" : ", ") + std::string("(") + rounded(w.x(), "%g") + ", " + rounded(w.y(), "%g") +
                 ", " + rounded(w.z(), "%g") + ")";
    }
    out.text("engines_throws", "ω = " + words + " rad/s", "short, middle and long axis");
}

// Explicit Euler bursts at a moment that hangs on roundoff: ω in the world's axes instead of the
// body's, or another start, as near as roundoff, shifts it.
void burst_moment(const Body& brick, lab::Findings& out) {
    const double E0 = kinetic_energy(brick, tumbling.omega), h = 1.0 / 60, patience = 60;
    const auto intact = [&](double energy, double t) { return energy < 1e6 * E0 && t < patience; };
    RigidState<double> in_the_world = in_world(tumbling);
    while (intact(kinetic_energy(brick, in_the_world), in_the_world.t))
        in_the_world = step_rotation(explicit_gyroscopic, brick, in_the_world, h);
    const double apart = 1e-12;
    const int many = 100;
    const Steps take = method("explicit_euler").made(brick);
    double earliest = patience, latest = 0;
    for (int n = 0; n < many; ++n) {
        Spin s = tumbling;
        s.omega.x() += apart * n / many;
        while (intact(kinetic_energy(brick, s.omega), s.t)) s = take(s, h, 1);
        earliest = std::min(earliest, s.t), latest = std::max(latest, s.t);
    }
    out.number("engines_burst_in_world", in_the_world.t, "s",
               "until explicit Euler has blown up, with the spin in the world's axes", 4);
    out.number("engines_burst_earliest", earliest, "s",
               "the same with it in the body's, of many starts that are as near as roundoff", 4);
    out.number("engines_burst_latest", latest, "s", "the latest of them", 4);
    out.number("engines_burst_starts", many, "", "how many starts");
    out.number("engines_burst_apart", apart, "rad/s", "how near they are");
    out.check(
        "engines_burst_moment",
        earliest < latest && latest - earliest < 1 && in_the_world.t > earliest - 0.5 && in_the_world.t < latest + 0.5,
        "explicit Euler: starts within 1e-12 rad/s burst at different times, within a "
        "second; so does the same start with its spin in the world's axes");
}

// The orientation's largest error in two seconds: 2 sin(α/2) for an angle α.
double error(const Method& method, const Body& I, const Spin& start) {
    const Exact exact(I, start);
    const Steps take = method.made(I);
    double worst = 0;
    Spin s = start;
    for (int n = 1; n <= 120; ++n) {
        s = take(s, 1.0 / 60, 1);
        const auto off = s.q.conjugate() * exact(n / 60.0).q;
        worst = std::max(worst, 2 * off.vec().norm());
    }
    return worst;
}

// What implicit midpoint and Moser-Veselov pay: Newton steps, and time; and what that buys.
void price(const Body& brick, const std::map<std::string, double>& ns, lab::Findings& out) {
    long iterations = 0;
    Spin s = tumbling;
    for (int n = 0; n < 3600; ++n) s = midpoint_spin.step(brick, s, 1.0 / 60, [&] { ++iterations; });
    const double each = double(iterations) / 3600;
    const auto over = [&](const char* key) { return ns.at(key) / ns.at("half_step"); };
    std::printf("  Over half-step: implicit midpoint x %s, Moser-Veselov 4 x %s.\n",
                plain(over("implicit_midpoint")).c_str(), plain(over("moser_veselov_4")).c_str());
    out.number("engines_midpoint_newton", each, "", "Newton steps in a step of implicit midpoint", 2);
    out.number("engines_midpoint_price", over("implicit_midpoint"), "", "its time over that of the half-step Jacobian",
               2);
    out.number("engines_veselov_4_price", over("moser_veselov_4"), "", "the same of order four", 2);
    out.check("engines_midpoint_price", each > 2,
              "implicit midpoint: more than two Newton steps in a step of this box");

    bool no_nearer = true;
    const Method &midpoint = method("implicit_midpoint"), &half_step = method("half_step");
    for (const Throw& thrown : throws)
        no_nearer = no_nearer && error(midpoint, brick, thrown.start) >= error(half_step, brick, thrown.start);
    out.number("engines_midpoint_error", error(midpoint, brick, tumbling), "rad",
               "implicit midpoint: the orientation's error, the middle throw, two seconds at 60 Hz", 2);
    out.number("engines_half_step_error", error(half_step, brick, tumbling), "rad", "the half-step Jacobian's", 2);
    out.check("engines_midpoint_error", no_nearer,
              "in each of the three throws, in two seconds, implicit midpoint's orientation is no "
              "nearer than the half-step Jacobian's");
}

// Is Buss's longer step nearer than his shorter one? And what a remembered slope is worth.
void flight(const Body& brick, lab::Findings& out) {
    bool no_nearer = true;
    for (const Throw& thrown : throws)
        no_nearer = no_nearer &&
                    error(method("buss_augmented"), brick, thrown.start) > error(method("buss_2"), brick, thrown.start);
    for (const char* key : {"buss_2", "buss_augmented", "adams_bashforth_2", "magnus_taylor_4", "spiers"})
        out.number(std::string("engines_error_") + key, error(method(key), brick, tumbling), "rad",
                   "the orientation's error, the middle throw, two seconds at 60 Hz", 2);
    out.check("engines_augmented", no_nearer,
              "in each of the three throws, in two seconds, the augmented step is farther off");
    const Body wheel(1, 1, 0.4);
    const Spin start = spin_of(1, 2, 10);
    out.check("engines_spiers_symmetric",
              error(method("spiers"), wheel, start) < 1e-11 && error(method("avian_proposed"), wheel, start) > 1e-3,
              "two equal moments: in two seconds Spiers's step of the whole body is off by "
              "roundoff, and one that hands a "
              "new ω to an engine is off");
}

}  // namespace

void engines(lab::Findings& out) {
    out.section("The rules of the engines");
    const Body brick = box(1.0, 1.0, 2.0, 3.0);
    const std::map<std::string, double>& ns = step_times();
    a_minute(brick, ns, out);
    burst_moment(brick, out);
    price(brick, ns, out);
    flight(brick, out);
    engines_fail(out);
}
