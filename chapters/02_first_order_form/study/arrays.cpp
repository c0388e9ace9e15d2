// Arrays of equations: several bodies in one state, and one solver for all scenes.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include <timestep/first_order_form.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/run.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;

// A first-order system, whatever it describes: f(t, y). The solver is compiled once for each size
// of y.
template <class Y>
using System = std::function<Y(double, const Y&)>;

// Steps it with RK4.
template <class Y>
FirstOrder<Y> stepped(const std::type_identity_t<System<Y>>& system, const FirstOrder<Y>& start, double h, int steps) {
    return run(runge_kutta_4, system, start, h, steps);
}

// What two ways of running the same scene have found. The bits are compared, not the numbers: what
// has blown up may be no number, and that is not equal to itself.
struct Compared {
    bool same = true, finite = true;

    void add(const double* a, const double* b, std::size_t n) {
        same = same && std::memcmp(a, b, n * sizeof *a) == 0;
        for (std::size_t i = 0; i < n; ++i) finite = finite && std::isfinite(a[i]);
    }
    std::string words() const {
        return std::string(same ? "the same bits" : "OTHER bits") + " as alone" +
               (finite ? "" : ",\n    and it blew up: the step is too long");
    }
};

// The character and the grenade know nothing of each other. One solver steps both, in one array of
// six numbers, and finds the same bits as two solvers, one for each.
Compared both_in_one_array(const Settings& settings) {
    /// [both]
    const FirstOrderForm legs{character(settings)};  // height, its velocity
    const FirstOrderForm shell{grenade(settings)};   // 2D position, velocity
    const auto both = [&](double t, const Vector6& y) -> Vector6 {
        Vector6 rate;
        rate << legs(t, y.head<2>()), shell(t, y.tail<4>());
        return rate;
    };
    /// [both]
    const State<double> landing{0, 0, -3};
    const auto y1 = stacked(landing);
    const auto y2 = stacked(throw_grenade());
    Vector6 y;
    y << y1.y, y2.y;

    const double h = settings.step;
    const auto together = stepped(both, FirstOrder<Vector6>{0, y}, h, 60);
    const auto first = stepped(legs, y1, h, 60);
    const auto second = stepped(shell, y2, h, 60);
    Compared result;
    result.add(together.y.data(), first.y.data(), 2);
    result.add(together.y.data() + 2, second.y.data(), 4);
    return result;
}

// Eight springs, each stiffer than the one before, in one array of sixteen.
Compared many_in_one_array(const Settings& settings) {
    constexpr int n = 8;
    using Array = Eigen::Matrix<double, 2 * n, 1>;
    std::vector<FirstOrderForm<Spring<double>>> springs;
    for (int i = 1; i <= n; ++i) springs.emplace_back(Spring(0.3 * i * settings.omega()));
    const auto all = [&](double t, const Array& y) -> Array {
        Array rate;
        for (int i = 0; i < n; ++i) rate.segment<2>(2 * i) = springs[i](t, y.segment<2>(2 * i));
        return rate;
    };
    Array y;
    for (int i = 0; i < n; ++i) y.segment<2>(2 * i) << dip, 0.1 * i;

    const auto together = stepped(all, FirstOrder<Array>{0, y}, settings.step, 60);
    Compared result;
    for (int i = 0; i < n; ++i) {
        const FirstOrder<Vector2> start{0, Vector2(dip, 0.1 * i)};
        const FirstOrder<Vector2> alone = stepped(springs[i], start, settings.step, 60);
        result.add(together.y.data() + 2 * i, alone.y.data(), 2);
    }
    return result;
}

// Two characters side by side, tied by a spring a tenth as stiff as their legs.
void coupled(const Settings& settings, lab::Findings& out) {
    const double k = settings.stiffness;
    const CoupledSprings row(Vector2(settings.mass, settings.mass), Vector3(k, k / 10, k));
    const State start{0, Vector2(dip, 0), Vector2(0, 0)};
    const double seconds = 12 * settings.period();
    auto& curve = out.table("coupled.tsv", {"t", "x1", "x2"});
    for (int i = 0; i <= 600; ++i) {
        const State<Vector2> s = row.exact(start, seconds * i / 600);
        curve.row({s.t, s.x(0), s.x(1)});
    }
    auto& dots = out.table("coupled_dots.tsv", {"t", "x1", "x2"});
    const int steps = 12 * 40;  // 40 a swing
    double worst = 0;
    int i = 0;
    run(runge_kutta_4, row, start, seconds / steps, steps, [&](const State<Vector2>& s) {
        worst = std::max(worst, (s.x - row.exact(start, s.t).x).norm());
        if (i++ % 5 == 0) dots.row({s.t, s.x(0), s.x(1)});
    });
    const Vector2 w = row.frequencies();
    std::printf("  two bodies tied by a spring: modes at %.4g and %.4g rad/s\n", w(0), w(1));
    std::printf("  RK4, 40 steps a period, is never more than %.1e m off\n", worst);
    out.number("mode_together", w(0), "rad/s", "frequency of the mode in which both go the same way");
    out.number("mode_against", w(1), "rad/s", "frequency of the mode in which they go opposite ways");
    out.number("beat", 2 * pi / (w(1) - w(0)), "s", "time in which the oscillation wanders over and back");
    out.number("coupled_error", 1000 * worst, "mm", "largest distance of RK4 from the exact motion", 2);
    // RK4 turns each mode late by (ωh)⁵/120 a step: over 12 swings of 40 steps with ωh = 2π/40, and
    // 1.1 times that for the faster mode, 480 · 1.6 · (2π/40)⁵/120 = 6e-4 of the amplitude.
    out.check("coupled_follows", worst < 6e-4 * dip, "RK4 follows the exact motion of the coupled bodies");
}

// One solver, every scene: only numbers go in and out.
struct Everything {
    const Settings& settings;
    lab::Findings& out;
    lab::Table& table;
    int scenes = 0;

    template <class Y>
    void scene(const char* name, const char* equation, const std::type_identity_t<System<Y>>& system,
               const FirstOrder<Y>& start, const Y& answer) {
        ++scenes;
        const FirstOrder<Y> end = stepped(system, start, 1.0 / 60, 60);
        double error = 0, size = 1;
        if constexpr (std::is_same_v<Y, double>)
            error = std::fabs(end.y - answer);
        else {
            error = (end.y - answer).norm();
            size = static_cast<double>(end.y.size());
        }
        char cell[32] = "blew up";
        if (std::isfinite(error)) std::snprintf(cell, sizeof cell, "%.1e", error);
        std::printf("    %-24s %g number%s %s%s\n", name, size, size == 1 ? ", " : "s,",
                    std::isfinite(error) ? "off by " : "", cell);
        table.row({name, equation, size, cell});
        out.check("solves_scene_" + std::to_string(scenes), error < 1e-3,
                  "one solver steps the scene: " + std::string(name));
    }

    // Where no exact solution is known, the same in steps 64 times smaller.
    template <class Y>
    void hard_scene(const char* name, const char* equation, const std::type_identity_t<System<Y>>& system,
                    const FirstOrder<Y>& start) {
        const Y answer = stepped(system, start, 1.0 / 60 / 64, 60 * 64).y;
        scene(name, equation, system, start, answer);
    }
};

void one_solver(const Settings& settings, lab::Findings& out) {
    std::printf("  one solver, RK4 in 60 steps, and one second of every scene:\n");
    auto& table = out.table("scenes.tsv", {"scene", "rate of change of y", "numbers in y", "error after 60 steps"});
    Everything every{settings, out, table};

    every.scene("fading sound", "$-3y$", Decay{-3.0}, FirstOrder{0, 1.0}, std::exp(-3.0));
    const Projectile fall{Vector2(0, -gravity)};
    every.scene("grenade without drag", "$(v,\\ g)$", FirstOrderForm{fall}, stacked(throw_grenade()),
                stacked(fall.exact(throw_grenade(), 1)).y);
    const Spring spring(settings.omega());
    every.scene("spring", "$(v,\\ -\\omega^2x)$", FirstOrderForm{spring}, stacked(State{0, dip, 0.0}),
                stacked(spring.exact(State{0, dip, 0.0}, 1)).y);
    // The character swings about its equilibrium as its legs alone would about zero.
    const State landing{0, 0.0, -3.0};
    const double sag = -gravity / (spring.omega * spring.omega);
    State stands = settings.legs().exact(State{0, landing.x - sag, landing.v}, 1);
    stands.x += sag;
    every.scene("character on its legs", "$(v,\\ -\\omega^2x - 2\\zeta\\omega v - g)$",
                FirstOrderForm{character(settings)}, stacked(landing), stacked(stands).y);
    every.hard_scene("grenade with drag", "$(v,\\ g - k\\lvert v\\rvert v)$", FirstOrderForm{grenade(settings)},
                     stacked(throw_grenade()));
    every.hard_scene("tether in space", "$(v,\\ -\\omega^2(\\lvert x\\rvert - L)\\,x/\\lvert x\\rvert)$",
                     FirstOrderForm{Tether{6.0, 1.0}}, stacked(State{0, Vector3(1.5, 0, 0.5), Vector3(0, 3, 1)}));
    const CoupledSprings row(Vector2(80, 80), Vector3(5120, 512, 5120));
    const State pulled{0, Vector2(dip, 0), Vector2(0, 0)};
    every.scene("two coupled bodies", "$v$, and the springs' pulls over the masses", FirstOrderForm{row},
                stacked(pulled), stacked(row.exact(pulled, 1)).y);
    out.number("scenes", every.scenes, "", "scenes that one solver steps");
}

}  // namespace

void arrays(const Settings& settings, lab::Findings& out) {
    out.section("Several bodies, one solver");
    coupled(settings, out);
    const Compared both = both_in_one_array(settings), many = many_in_one_array(settings);
    std::printf("  character and grenade in one array: %s\n", both.words().c_str());
    std::printf("  eight springs in one array: %s\n", many.words().c_str());
    out.check("both_same_bits", both.same, "character and grenade in one array give the same bits as alone");
    out.check("many_same_bits", many.same, "eight springs in one array give the same bits as eight runs");
    one_solver(settings, out);
}
