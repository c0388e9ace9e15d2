// Equations whose answer we know, and one solver that finds each of them without knowing it.

#include <cmath>
#include <cstdio>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// Steps ẋ = f(t, x) with RK4 from x(0) and compares each state with the answer. Is it close enough?
template <class System, class Exact>
bool solve(const char* name, const char* equation, const System& f, double x0, const Exact& exact, lab::Findings& out) {
    auto& curve = out.table(std::string("solution_") + name + ".tsv", {"t", "x"});
    for (int i = 0; i <= 100; ++i) curve.row({0.04 * i, exact(0.04 * i)});

    auto& dots = out.table(std::string("solved_") + name + ".tsv", {"t", "x"});
    double worst = 0;
    run(runge_kutta_4, f, FirstOrder{0, x0}, 0.25, 16, [&](const auto& s) {
        dots.row({s.t, s.y});
        worst = std::max(worst, std::fabs(s.y - exact(s.t)));
    });
    std::printf("  %-11s solved in 16 steps, at most %.1e off\n", equation, worst);
    out.number(std::string("error_") + name, worst, "", "largest error of 16 steps of RK4", 2);
    // RK4 leaves out the Taylor series from the fifth term on: h⁵/120 a step of an x of 2 at most.
    return worst < 16 * std::pow(0.25, 5) / 120 * 2;
}

void first_order(lab::Findings& out) {
    out.section("First-order equations");
    const auto constant = [](double, double) { return 0.5; };             // ẋ = 1/2
    const auto time_only = [](double t, double) { return std::cos(t); };  // ẋ = cos t
    const Decay decay{-1.0};                                              // ẋ = −x
    const Decay growth{0.5};                                              // ẋ = x/2
    const bool line = solve(
        "line", "x' = 1/2", constant, -1, [](double t) { return -1 + 0.5 * t; }, out);
    const bool integral = solve(
        "integral", "x' = cos t", time_only, 0, [](double t) { return std::sin(t); }, out);
    const bool fades = solve(
        "decay", "x' = -x", decay, 2,
        [&](double t) {
            return decay.exact(FirstOrder{0, 2.0}, t).y;
        },
        out);
    const bool grows = solve(
        "growth", "x' = x/2", growth, 0.5,
        [&](double t) {
            return growth.exact(FirstOrder{0, 0.5}, t).y;
        },
        out);
    out.check("one_solver_for_all", line && integral && fades && grows,
              "16 steps of one solver find a line, an integral, a decay and a growth");
}

void projectile(lab::Findings& out) {
    const Projectile fall{Vector2(0, -gravity)};
    const State<Vector2> start = throw_grenade();
    const double flight = 2 * start.v.y() / gravity;
    auto& path = out.table("projectile.tsv", {"t", "x", "y"});
    for (int i = 0; i <= 100; ++i) {
        const State<Vector2> s = fall.exact(start, flight * i / 100);
        path.row({s.t, s.x.x(), s.x.y()});
    }
    auto& arrows = out.table("projectile_velocity.tsv", {"t", "x", "y", "vx", "vy"});
    for (int i = 0; i <= 8; ++i) {
        const State<Vector2> s = fall.exact(start, flight * i / 8);
        arrows.row({s.t, s.x.x(), s.x.y(), s.v.x(), s.v.y()});
    }
    const State<Vector2> top = fall.exact(start, flight / 2);
    const State<Vector2> landing = fall.exact(start, flight);
    std::printf(
        "  y'' = -g          a throw at %g m/s and 45 degrees rises %.2f m\n"
        "                    and lands after %.2f s and %.2f m\n",
        throw_speed, top.x.y(), flight, landing.x.x());
    out.number("flight_height", top.x.y(), "m", "its highest point");
    out.number("flight_range", landing.x.x(), "m", "where it lands", 4);
    out.number("throw_speed", throw_speed, "m/s", "speed of the throw");
}

// The frequency depends on k/m alone.
void spring_parameters(const Settings& settings, lab::Findings& out) {
    const double m = settings.mass, k = settings.stiffness;
    const auto omega = [](double k, double m) { return Spring<double>::from_stiffness(k, m).omega; };
    std::printf(
        "  x'' = -omega^2 x  %g kg on %g N/m: omega = %.4g rad/s,\n"
        "                    the period is %.3f s\n",
        m, k, omega(k, m), settings.period());
    out.number("mass", m, "kg", "the character's mass");
    out.number("stiffness", k, "N/m", "stiffness of its legs");
    out.number("omega", omega(k, m), "rad/s", "angular frequency of the character on its legs");
    out.number("period", settings.period(), "s", "the period");
    out.number("omega_four_masses", omega(k, 4 * m), "rad/s", "the same with four times the mass");
    out.number("omega_four_springs", omega(4 * k, m), "rad/s", "with four times the stiffness");
    out.check("stiffer_is_faster", omega(4 * k, m) > omega(k, m), "a stiffer spring swings faster");
    out.check("heavier_is_slower", omega(k, 4 * m) < omega(k, m), "a heavier mass swings slower");
}

}  // namespace

void solutions(const Settings& settings, lab::Findings& out) {
    first_order(out);
    out.section("Second-order equations");
    projectile(out);
    spring_parameters(settings, out);
}
