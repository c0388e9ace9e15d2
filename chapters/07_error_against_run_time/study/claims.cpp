// What the page says of the diagrams, looked up in the points.

#include <cmath>
#include <limits>
#include <random>

#include <timestep/methods.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/run.hpp>

#include "contest/scenes.hpp"
#include "sections.hpp"

using namespace contest;

namespace {

// The points of one method in one scene, steps growing shorter.
std::vector<Point> line(const std::vector<Point>& points, const std::string& method, const std::string& library) {
    std::vector<Point> line;
    for (const Point& p : points)
        if (p.method == method && p.library == library) line.push_back(p);
    return line;
}

// The point of that many steps a second; a NaN of an error where there is none.
Point at(const std::vector<Point>& line, double rate) {
    for (const Point& p : line)
        if (std::fabs(p.step * rate - 1) < 1e-6) return p;
    Point none;
    none.error_max = none.seconds = std::nan("");
    return none;
}

// Seconds for an accuracy, by this method alone.
double seconds_to(const std::vector<Point>& line, double accuracy) {
    return cheapest(line, accuracy, [](const Point&) { return true; }).seconds;
}

void percent(lab::Findings& out, const std::string& name, double share, const std::string& meaning,
             lab::Place from = lab::Place::here()) {
    out.number(name, 100 * share, "%", meaning, share < 1 ? 2 : 3, from);
}

// The slope of our method's line on the spring from a rate to four times that. Of errors alone, so
// that a slow machine comes as far as a fast one.
double slope(const char* method, double rate) {
    const Scene scene = contest::spring();
    for (const Entry& entry : scene.entries)
        if (entry.method == method && entry.library == "Timestep") {
            const auto error = [&](double hz) { return watched(scene, entry, std::lround(hz * duration)).error_max; };
            return std::log2(error(rate) / error(4 * rate)) / 2;
        }
    return std::nan("");
}

void springs(const All& all, lab::Findings& out) {
    const auto& spring = all.at("spring");
    const auto of = [&](const char* method) { return line(spring, method, "Timestep"); };
    const auto semi = of("semi-implicit Euler"), verlet = of("Verlet"), rk4 = of("Runge-Kutta 4");
    out.check("slopes",
              std::fabs(slope("semi-implicit Euler", 960) - 1) < 0.05 && std::fabs(slope("Verlet", 960) - 2) < 0.05 &&
                  std::fabs(slope("Runge-Kutta 4", 60) - 4) < 0.1,
              "the lines of semi-implicit Euler, Verlet and RK4 have the slopes 1, 2 and 4");
    percent(out, "semi_60", at(semi, 60).error_max, "error of semi-implicit Euler at 60 Hz on the spring");
    percent(out, "verlet_60", at(verlet, 60).error_max, "error of Verlet at 60 Hz on the spring");
    percent(out, "rk4_15", at(rk4, 15).error_max, "error of RK4 at 15 Hz on the spring");
    out.check("verlet_by_half_a_step", at(verlet, 60).error_max < 0.3 * at(semi, 60).error_max,
              "on the spring Verlet at 60 Hz is several times as accurate as semi-implicit Euler");
    // Started with the velocity of half a step before, semi-implicit Euler is Verlet.
    const timestep::Spring model(2 * pi);
    const double h = 1.0 / 60;
    const timestep::State start{0, 1.0, 0.0};
    const timestep::State earlier{0, 1.0, 0.0 - h / 2 * model.acceleration(1.0)};
    const int n = 230;  // each step rounds its displacement by ε, and keeps that for the steps to come
    out.check("half_a_step_before",
              std::fabs(run(timestep::semi_implicit_euler, model, earlier, h, n).x -
                        run(timestep::verlet, model, start, h, n).x) < n * n * std::numeric_limits<double>::epsilon(),
              "with the velocity of half a step before the start semi-implicit Euler goes where "
              "Verlet goes");
    // Errors alone, so that a slow machine comes as far as a fast one.
    double floor = 1, beyond = 1;
    for (const Scene scene = contest::spring(); const Entry& entry : scene.entries)
        if (entry.method == "Runge-Kutta 4" && entry.library == "Timestep")
            for (long steps = marks; steps <= marks << 14; steps *= 2) {
                beyond = watched(scene, entry, steps).error_max;
                floor = std::min(floor, beyond);
            }
    out.number("floor", floor, "", "the least error of RK4 on the spring", 1);
    out.check("floor", floor < 1e-12 && beyond > floor,
              "RK4 reaches the floor of double: shorter steps than the best make it worse");
    const auto single = line(spring, "Runge-Kutta 4", "Timestep, float");
    double least = 1;
    for (const Point& p : single) least = std::min(least, p.error_max);
    out.number("float_floor", least, "", "the least error of RK4 in float on the spring", 1);
    double most = 0;
    for (const Point& p : single)
        if (p.step < 1.0 / 100) most = std::max(most, p.error_max);
    out.number("float_ceiling", most, "", "the largest error of RK4 in float beyond 100 Hz", 1);
    double rate = 7.5;  // up to here float is as good as double
    while (at(single, rate).error_max < 1.1 * at(rk4, rate).error_max) rate *= 2;
    out.number("float_rate", rate, "Hz", "rate from which on RK4 in float is worse than in double");
    out.check("float_floor", least > 1e-7 && at(single, 60).error_max < 1e-4,
              "in float RK4 comes no nearer than 1e-7, whatever the step");

    const auto& stiff = all.at("stiff_spring");
    const auto stiff_semi = line(stiff, "semi-implicit Euler", "Timestep");
    percent(out, "stiff_semi_60", at(stiff_semi, 60).error_max, "error of semi-implicit Euler at 60 Hz, stiff spring");
    out.check(
        "stiff_nobody_at_60",
        [&] {
            for (const Point& p : stiff)
                if (p.library == "Timestep" && p.step > 0.016 && p.error_max < 0.5) return false;
            return true;
        }(),
        "no method of the course is right at 60 Hz about where a spring of 100 rad/s is");

    const auto& two = all.at("two_time_scales");
    const auto middle = line(two, "implicit midpoint", "Timestep");
    percent(out, "two_midpoint_60", at(middle, 60).error_max, "error of implicit midpoint at 60 Hz, two time scales");
    out.check("two_needs_implicit",
              at(middle, 60).error_max < 0.1 && at(line(two, "semi-implicit Euler", "Timestep"), 60).diverged &&
                  at(line(two, "Runge-Kutta 4", "Timestep"), 60).diverged,
              "at 60 Hz implicit midpoint follows the slow motion, and explicit methods have blown up");
}

void flight(const All& all, lab::Findings& out) {
    bool as_said = true;
    for (const Point& p : all.at("projectile"))
        if (p.library == "Timestep") {
            const bool euler =
                p.method == "explicit Euler" || p.method == "implicit Euler" || p.method == "semi-implicit Euler";
            as_said = as_said && (euler ? p.asked > marks || p.error_max > 1e-2 : p.error_max < 1e-10);
        }
    out.check("flight_exact", as_said,
              "without air our methods are exact at every rate, to roundoff, but for the three "
              "Eulers, which are over 1 % off at 7.5 Hz");
}

void bounces(const All& all, lab::Findings& out) {
    const auto& smooth = all.at("drag");
    const auto& ball = all.at("bouncing_ball");
    const auto of = [](const auto& points, const char* method) { return line(points, method, "Timestep"); };
    const auto rk4 = of(ball, "Runge-Kutta 4"), semi = of(ball, "semi-implicit Euler");
    percent(out, "bounce_semi_60", at(semi, 60).error_max, "error of semi-implicit Euler at 60 Hz, bouncing");
    percent(out, "bounce_rk4_60", at(rk4, 60).error_max, "error of RK4 at 60 Hz, bouncing");
    const double smooth_rk4 = at(of(smooth, "Runge-Kutta 4"), 60).error_max;
    out.number("drag_rk4_60", smooth_rk4, "", "error of RK4 at 60 Hz, no bounce", 1);
    out.check("bounces_level",
              at(rk4, 60).error_max > 0.5 * at(semi, 60).error_max &&
                  smooth_rk4 < 1e-4 * at(of(smooth, "semi-implicit Euler"), 60).error_max,
              "where a ball bounces RK4 is no better than semi-implicit Euler; where it only "
              "flies, ten thousand times");
    double least = 1, largest = 0;
    for (const Point& p : ball)
        if (p.library == "Timestep" && p.asked == 240) {
            least = std::min(least, p.error_max);
            largest = std::max(largest, p.error_max);
        }
    out.number("bounce_spread", largest / least, "", "the largest error over the least at 60 Hz, bouncing", 1);
}

// What semi-implicit Euler takes for ten percent, less what the best takes, where nothing is stiff.
void ten_percent(const All& all, lab::Findings& out) {
    double most = 0, ratio = 0;
    for (const char* scene : {"projectile", "drag", "spring", "damped_spring", "spring_3d", "bouncing_ball"}) {
        const auto& points = all.at(scene);
        const double semi = seconds_to(line(points, "semi-implicit Euler", "Timestep"), 0.1);
        const auto ours = [](const Point& p) { return p.library == "Timestep"; };
        const double best = cheapest(points, 0.1, ours).seconds;
        most = std::max(most, semi - best);
        ratio = std::max(ratio, semi / best);
    }
    out.number("ten_percent_ratio", ratio, "", "and how many times as long, at most", 2);
    out.number("springs_a_ms", 1e-6 / (at(line(all.at("spring"), "semi-implicit Euler", "Timestep"), 60).seconds / 240),
               "thousand", "steps of semi-implicit Euler in a millisecond", 3);
    out.number("ten_percent_loss", most * 1e6, "µs",
               "what semi-implicit Euler takes longer than the best to ten percent, at most", 2);
}

// What RK4 makes of the energy of the free box, from many directions of spin.
struct Kept {
    double share = 0;  // of the directions from which the first step adds energy
    double most = 0;   // what any of them has gained after any step
    double least = 1;  // what the worst has left in the end
};
Kept rk4_keeps(double h_omega, int directions, int steps) {
    const auto inertia = timestep::box(12.0, 1.0, 2.0, 3.0);
    const timestep::FreeBody body(inertia);
    std::mt19937 random(1);
    Kept kept;
    for (int i = 0; i < directions; ++i) {
        // Uniform on the sphere: a height, and an angle around.
        const double height = 2 * (random() / 4294967296.0) - 1, around = 2 * pi * (random() / 4294967296.0);
        const double wide = std::sqrt(1 - height * height);
        timestep::RigidState<double> s{
            0, timestep::Quaternion<double>::Identity(), {wide * std::cos(around), wide * std::sin(around), height}};
        const double before = kinetic_energy(inertia, s);
        double now = 1;
        for (int step = 0; step < steps; ++step) {
            s = timestep::unstacked(orientation_scaled(timestep::runge_kutta_4.step(body, stacked(s), h_omega)));
            now = kinetic_energy(inertia, s) / before;
            if (step == 0 && now > 1) kept.share += 1.0 / directions;
            kept.most = std::fmax(kept.most, now - 1);
        }
        kept.least = std::fmin(kept.least, now);
    }
    return kept;
}

void spins(const All& all, lab::Findings& out) {
    const int directions = 2000, steps = 300;
    const Kept one = rk4_keeps(1, directions, steps), fast_spin = rk4_keeps(2.5, directions, steps);
    out.number("spin_directions", directions, "", "directions of spin from which RK4 has stepped the box");
    out.number("spin_steps", steps, "", "steps from each");
    out.number("spin_rk4_turns", 60 / (2 * pi), "", "turns a second at h|omega| = 1 and 60 Hz", 2);
    percent(out, "spin_rk4_share", one.share, "directions from which RK4's first step adds energy, h|omega| = 1");
    percent(out, "spin_rk4_most", one.most, "the most energy that RK4 had added, h|omega| = 1");
    percent(out, "spin_rk4_lost", 1 - one.least, "the most that was lost in the end, h|omega| = 1");
    percent(out, "spin_rk4_most_fast", fast_spin.most, "the most energy that RK4 had added, h|omega| = 2.5");
    percent(out, "spin_rk4_lost_fast", 1 - fast_spin.least, "the most that was lost in the end, h|omega| = 2.5");
    out.check("spin_rk4_slow",
              one.share > 0.1 && one.most < 1e-3 && one.least > 0.9 && fast_spin.most > 5e-3 && fast_spin.least < 0.5,
              "at h|omega| = 1 RK4 adds energy from over a tenth of these directions, from none a "
              "thousandth, and "
              "keeps nine tenths in every one of them; at 2.5 it adds over half a percent and "
              "loses over half");
    const auto& box = all.at("dzhanibekov");
    const auto of = [&](const char* method) { return line(box, method, "Timestep"); };
    const auto rk4 = of("Runge-Kutta 4"), talk = of("one Newton step"), converged = of("implicit, converged");
    const Point slow = at(rk4, 15), fast = at(talk, 960);
    percent(out, "spin_rk4_15", slow.error_max, "error of RK4 at 15 Hz, free box");
    percent(out, "spin_talk_60", at(talk, 60).error_max, "error of the talk's solver at 60 Hz, free box");
    percent(out, "spin_talk_960", fast.error_max, "error of the talk's solver at 960 Hz, free box");
    out.number("spin_time_ratio", fast.seconds / slow.seconds, "",
               "time of the talk's solver at 960 Hz over RK4 at 15 Hz", 2);
    out.check("spin_rk4_wins", slow.error_max < fast.error_max,
              "on a free box RK4 at 15 Hz is nearer to the truth than the talk's solver at 960 Hz");
    out.check("more_iterations", at(talk, 240).error_max < 1.05 * at(converged, 240).error_max,
              "more Newton iterations bring a tumbling box no nearer to the truth");
    const auto top = [&](const char* method) { return line(all.at("symmetric_top"), method, "Timestep"); };
    const auto passive = top("passive");
    bool nearer = true;
    for (const char* other : {"explicit", "dropped", "one Newton step", "implicit, converged"})
        for (double rate = 7.5; rate < 250; rate *= 2)
            nearer = nearer && at(passive, rate).error_max < at(top(other), 2 * rate).error_max;
    out.check("top_passive", nearer,
              "a capsule in the air, up to 240 Hz: passive is nearer than explicit, dropped, one "
              "Newton step and "
              "converged at twice the rate");
    out.number("spin_converged_cost", at(converged, 240).seconds / at(talk, 240).seconds, "",
               "time of many iterations over one, 240 Hz", 2);
}

void on_ice(const All& all, lab::Findings& out) {
    const auto& ice = all.at("capsule_on_plane");
    const auto passive = line(ice, "passive", "Timestep"),
               air = line(ice, "Runge-Kutta 4 in the air, passive", "Timestep");
    percent(out, "ice_passive_60", at(passive, 60).error_max, "error of passive at 60 Hz, ice");
    percent(out, "ice_rk4_60", at(air, 60).error_max, "error of passive with RK4 in the air at 60 Hz, ice");
    out.check("ice_level", at(air, 60).error_max > 0.5 * at(passive, 60).error_max,
              "on ice RK4 in the air gains nothing");
}

// RK4 on the spring at 240 Hz: how long others take for the same steps, with ours as one.
void peers(const All& all, lab::Findings& out) {
    const auto& spring = all.at("spring");
    const Point mine = at(line(spring, "Runge-Kutta 4", "Timestep"), 240);
    const struct {
        const char *name, *method, *library;
    } others[] = {{"rk4_odeint", "Runge-Kutta 4", "Boost.odeint"},
                  {"rk4_gsl", "Runge-Kutta 4, doubled", "GSL"},
                  {"rk4_sundials", "Runge-Kutta 4", "SUNDIALS"}};
    std::string there;
    for (const auto& [name, method, library] : others) {
        const Point p = at(line(spring, method, library), 240);
        const std::string meaning = std::string("time of RK4, ") + library + " over ours";
        if (std::isnan(p.seconds)) {
            out.text(name, "", meaning);  // none: it is not installed
            continue;
        }
        out.number(name, p.seconds / mine.seconds, "", meaning, 2);
        there += (there.empty() ? "" : ", ") + std::string(library);
    }
    const Point here = at(line(all.at("spring_3d"), "Runge-Kutta 4", "Timestep"), 240);
    const Point other = at(line(all.at("spring_3d"), "Runge-Kutta 4", "Boost.odeint"), 240);
    if (std::isnan(other.seconds))
        out.text("rk4_odeint_3d", "", "time of RK4 in space, Boost.odeint over ours");
    else
        out.number("rk4_odeint_3d", other.seconds / here.seconds, "", "time of RK4 in space, Boost.odeint over ours",
                   2);
    const Cheapest six = cheapest(spring, 1e-6, [](const Point&) { return true; });
    out.text("six_digits", six.method + " (" + six.library + ")", "the cheapest of all to a millionth on the spring");
    out.text("peers", there, "libraries that were there; without any of them the page leaves their section out");
}

}  // namespace

void claims(const All& all, lab::Findings& out) {
    springs(all, out);
    flight(all, out);
    bounces(all, out);
    ten_percent(all, out);
    spins(all, out);
    on_ice(all, out);
    peers(all, out);
}
