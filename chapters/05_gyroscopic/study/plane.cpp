// The capsule on a plane: every way to treat the gyroscopic torque inside a small physics engine.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "plane_solvers.hpp"
#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double long_enough = 20;  // s, after which we stop waiting for rest
constexpr double still = 1e-3;      // rad/s and m/s: what counts as rest
constexpr double lost = 1000;       // rad/s: what counts as blown up

struct Outcome {
    double rest = -1;        // the time from which it lies still, s; −1 if it never does
    double blown_up = -1;    // the time at which it was lost
    double spin = 0;         // |ω| at the end, rad/s
    double most_spin = 0;    // and the largest
    double upright = 0;      // angle of its axis above the plane at the end, degrees
    double most_energy = 0;  // over that at the start
    double energy = 0;       // at the end over that at the start
    double sunk = 0;         // m
};

double angle_above_plane(const plane::BodyState& m) {
    const double z = (m.turning.q * plane::V::UnitZ()).z();
    return std::asin(std::min(1.0, std::fabs(z))) * 180 / std::acos(-1.0);
}

// Runs until rest, loss or the end; `observe` sees each state.
using Observe = std::function<void(const plane::BodyState&)>;
template <class Inertia>
Outcome watch(
    const scene::PlaneSolver& solver, const plane::Capsule<Inertia>& body, const plane::Ground& ground,
    plane::BodyState m, double h, const Observe& observe = [](const plane::BodyState&) {}) {
    Outcome result;
    const double start = energy(body, ground, m);
    plane::Contacts contacts;
    const long steps = std::lround(std::min(long_enough / h, 20000.0));
    for (long n = 0; n <= steps; ++n) {
        observe(m);
        result.spin = m.turning.omega.norm();
        result.most_spin = std::max(result.most_spin, result.spin);
        result.upright = angle_above_plane(m);
        if (!(result.spin < lost)) {
            result.blown_up = m.turning.t;
            return result;
        }
        result.energy = energy(body, ground, m) / start;
        result.most_energy = std::max(result.most_energy, result.energy);
        if (result.spin < still && m.v.norm() < still) {
            result.rest = m.turning.t;
            return result;
        }
        m = solver.step(body, ground, m, h, contacts);
        result.sunk = std::max(result.sunk, contacts.sunk);
    }
    return result;
}

std::string seconds(double t) {
    char text[24];
    std::snprintf(text, sizeof text, "%.1f s", t);
    return text;
}

std::string said(const Outcome& o) {
    if (o.blown_up >= 0) return "blown up after " + seconds(o.blown_up);
    if (o.rest >= 0) return "at rest after " + seconds(o.rest);
    char text[64];
    std::snprintf(text, sizeof text, o.spin < 1 ? "%.2g rad/s%s" : "%.0f rad/s%s", o.spin,
                  o.upright > 60  ? ", on its end"
                  : o.upright < 5 ? ", rolling"
                                  : "");
    return text;
}

// One scene, all variants: without rolling resistance and with it.
void one_throw(const Settings& settings, lab::Findings& out) {
    out.section("A capsule on a plane");
    const auto body = scene::capsule();
    const plane::BodyState start = scene::thrown(body);
    out.number("plane_spin", scene::spin, "rad/s", "spin of the capsule on the plane at the start");
    out.number("plane_seconds", long_enough, "s", "for which the capsule on the plane is watched");
    out.number("plane_rolling", scene::ground(0.1).rolling, "", "coefficient of rolling resistance, in radii");
    auto& table = out.table("plane.tsv",
                            {"gyroscopic torque", "no rolling resistance", "with rolling resistance", "most energy"});
    std::printf("%-24s %-26s %-26s\n", "gyroscopic torque", "no rolling resistance", "with it");

    Outcome with[6], without[6];
    int index = 0;
    for (const scene::PlaneSolver& solver : scene::plane_solvers()) {
        const std::string &key = solver.key, &name = solver.name;
        for (const bool resists : {false, true}) {
            auto& data = out.table("plane_" + std::string(resists ? "rolling_" : "free_") + key + ".tsv",
                                   {"t", "spin", "energy", "upright"});
            const plane::Ground ground = scene::ground(resists ? 0.1 : 0.0, plane::Arms::start);
            const double first = energy(body, ground, start);
            long n = 0;
            (resists
                 ? with
                 : without)[index] = watch(solver, body, ground, start, settings.step, [&](const plane::BodyState& m) {
                if (n++ % 3 != 0) return;
                data.row({m.turning.t, m.turning.omega.norm(), energy(body, ground, m) / first, angle_above_plane(m)});
            });
        }
        char most[32];
        std::snprintf(most, sizeof most, with[index].blown_up >= 0 ? "no bound" : "× %.2f", with[index].most_energy);
        table.row({name, said(without[index]), said(with[index]), std::string(most)});
        std::printf("%-24s %-26s %-26s\n", name.c_str(), said(without[index]).c_str(), said(with[index]).c_str());
        if (with[index].rest >= 0)
            out.number("plane_" + key + "_rest", with[index].rest, "s", name + ": at rest, with rolling resistance", 2);
        ++index;
    }
    out.number("plane_dropped_spin", with[1].spin, "rad/s", "dropped: spin at the end, with rolling resistance", 2);
    const Outcome &expl = with[0], &dropped = with[1], &old = with[2], &implicit = with[3], &converged = with[4],
                  &passive = with[5];
    out.number("plane_blown_up", expl.blown_up, "s", "explicit: blown up, with rolling resistance", 2);
    out.number("plane_explicit_peak", without[0].most_spin, "rad/s",
               "explicit: largest spin, without rolling resistance");
    // What is left of it at the end hangs on the last digits, as long as it has tumbled by then.
    out.check(
        "plane_explicit_lies",
        without[0].most_spin > 2 * scene::spin && without[0].spin < without[0].most_spin / 10 && without[0].upright < 5,
        "explicit without rolling resistance: the spin more than doubles, and in the end the "
        "capsule lies flat with less than a tenth of that");
    out.check("plane_explicit", expl.blown_up > 0, "explicit: the capsule on the plane blows up");
    out.check("plane_dropped", dropped.spin > 10 && dropped.most_energy <= 1 && dropped.upright > 80,
              "dropped: after 20 s with rolling resistance it stands on its end and spins");
    out.check("plane_old", old.spin > scene::spin && old.energy > 2,
              "momentum with lagged inertia: it stands on its end and spins faster than at the start");
    out.check("plane_rests", implicit.rest > 0 && passive.rest > 0, "implicit and passive: the capsule comes to rest");
    out.check("plane_one_iteration", implicit.rest == converged.rest && implicit.energy == converged.energy,
              "a capsule is symmetric: one Newton step and the converged solution are the same run");

    // The same scene, with steps so short that the way to treat the torque hardly matters.
    const auto with_step = [&](const char* key, double h) {
        return watch(scene::plane_solver(key), body, scene::ground(0.1, plane::Arms::start), start, h);
    };
    const Outcome fine = with_step("passive", settings.step / 32);
    const Outcome fine_implicit = with_step("implicit", settings.step / 32);
    const Outcome quarter_implicit = with_step("implicit", settings.step / 4);
    std::printf("%-24s %-26s %-26s\n", "one Newton step, h/4", "", said(quarter_implicit).c_str());
    std::printf("%-24s %-26s %-26s\n", "one Newton step, h/32", "", said(fine_implicit).c_str());
    std::printf("%-24s %-26s %-26s\n", "passive, h/32", "", said(fine).c_str());
    out.number("plane_fine_rest", fine.rest, "s", "passive: at rest, with a 32nd of the step", 2);
    out.number("plane_quarter_rest", quarter_implicit.rest, "s", "one Newton step: at rest, with a quarter of the step",
               2);
    out.check("plane_fine",
              fine.rest > 0 && fine_implicit.rest > 0 && std::fabs(fine.rest - fine_implicit.rest) < 0.1 &&
                  passive.rest < 2 * fine.rest && dropped.spin > 10,
              "a 32nd of the step: passive and one Newton step come to rest at the same time, to 0.1 "
              "s; with the whole step passive takes less than twice as long");
}

// A ball has no gyroscopic torque: every variant compiles to the same step.
void ball(const Settings& settings, lab::Findings& out) {
    const auto body = scene::ball();
    const plane::BodyState start = scene::thrown(body);
    std::vector<Outcome> outcomes;
    for (const scene::PlaneSolver& solver : scene::plane_solvers()) {
        if (solver.key == "lagged_inertia") continue;  // L = Iω turns back and forth, and picks up roundoff
        outcomes.push_back(watch(solver, body, scene::ground(0.1), start, settings.step));
    }
    bool same = true;
    for (const Outcome& o : outcomes) same = same && o.spin == outcomes[0].spin && o.energy == outcomes[0].energy;
    std::printf("%-24s %-26s %-26s\n", "a ball, any of them", "", said(outcomes[0]).c_str());
    out.check("plane_ball", same, "a ball moves alike, to the last digit, whatever is done to its torque");
}

// Many throws at random: how many come to rest, how many gain energy, and what the contacts' arms
// have to do with it.
void many_throws(const Settings& settings, lab::Findings& out) {
    out.section("Throws at random");
    constexpr int throws = 50;
    out.number("throws", throws, "", "capsules thrown at random");
    auto& table = out.table("plane_throws.tsv", {"gyroscopic torque", "contacts", "at rest", "blown up",
                                                 "gained energy", "spinning upright"});
    std::printf("%-24s %-9s %8s %8s %8s %8s\n", "", "arms", "at rest", "blown up", "gained", "upright");
    const auto body = scene::capsule();
    const auto run = [&](const std::string& key, const std::string& name, const scene::PlaneSolver& solver,
                         plane::Arms arms, double h) {
        const std::string word = arms == plane::Arms::start ? "start" : "middle";
        std::mt19937 random(5);
        int rested = 0, lost_ones = 0, gained = 0, upright = 0;
        double most = 0;
        std::vector<double> times;
        for (int k = 0; k < throws; ++k) {
            const Outcome o = watch(solver, body, scene::ground(0.1, arms), scene::random_throw(body, random), h);
            rested += o.rest >= 0;
            lost_ones += o.blown_up >= 0;
            gained += o.most_energy > 1 + 1e-6 || o.blown_up >= 0;
            upright += o.rest < 0 && o.blown_up < 0 && o.upright > 75;
            most = std::max(most, o.most_energy);
            if (o.rest >= 0) times.push_back(o.rest);
        }
        std::sort(times.begin(), times.end());
        auto& curve = out.table("throws_" + word + "_" + key + ".tsv", {"t", "moving"});
        curve.row({0.0, 100.0});
        for (std::size_t i = 0; i < times.size(); ++i) {
            curve.row({times[i], 100 - 100.0 * static_cast<double>(i) / throws});
            curve.row({times[i], 100 - 100.0 * static_cast<double>(i + 1) / throws});
        }
        curve.row({long_enough, 100.0 - 100.0 * rested / throws});
        table.row({name, word, double(rested), double(lost_ones), double(gained), double(upright)});
        std::printf("%-24s %-9s %8d %8d %8d %8d\n", name.c_str(), word.c_str(), rested, lost_ones, gained, upright);
        if (key == "passive" && arms == plane::Arms::start) {
            out.number("throws_start_passive_gained", gained, "", "throws that gained energy");
            out.check("throws_arms", gained > 0,
                      "with the arms of engines, contacts add energy even to throws with the "
                      "passive step");
        }
        if (key == "passive" && arms == plane::Arms::middle)
            out.check("throws_passive", rested == throws && gained == 0,
                      "passive step, arms in the middle: all come to rest and none gains energy");
        if (key == "passive_after" && arms == plane::Arms::start)
            out.check("throws_after", rested == throws && gained == 0,
                      "passive step after the contacts, arms of the start: all come to rest and "
                      "none gains energy");
        if (key == "passive_after" && arms == plane::Arms::middle)
            out.number("throws_both_most", most, "", "most energy, over that at the start, with both cures", 5);
        if (key == "dropped" && arms == plane::Arms::start)
            out.check("throws_dropped", upright > 0 && gained == 0,
                      "dropped: none gains energy, and some stand and spin in the end");
        if (key == "dropped" && arms == plane::Arms::middle)
            out.check("throws_dropped_middle", rested == throws, "dropped, arms in the middle: all come to rest");
        if (key == "explicit")
            out.check("throws_explicit_" + word, lost_ones > 0,
                      "explicit, arms at the " + word + ": some of the throws blow up");
    };
    const scene::PlaneSolver& after = scene::passive_after_contacts();
    for (const plane::Arms arms : {plane::Arms::start, plane::Arms::middle}) {
        for (const scene::PlaneSolver& solver : scene::plane_solvers())
            if (solver.key != "converged") run(solver.key, solver.name, solver, arms, settings.step);
        run(after.key, after.name, after, arms, settings.step);
    }
    run("fine", "passive, an eighth of the step", scene::plane_solver("passive"), plane::Arms::middle,
        settings.step / 8);
}

}  // namespace

void capsule_on_plane(const Settings& settings, lab::Findings& out) {
    one_throw(settings, out);
    ball(settings, out);
    many_throws(settings, out);
}
