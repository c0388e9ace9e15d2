// The game loop: what the frame rate does to a simulation, and what it need not do.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <random>
#include <vector>

#include <timestep/game_loop.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double seconds = 3;

// Never less than is due: what a cap does is another picture.
long most_steps(double step) { return std::lround(1 / step); }

using Frames = std::vector<double>;  // how long each of them takes, s

Frames steady(double frames_a_second) { return Frames(std::lround(seconds * frames_a_second), 1 / frames_a_second); }

// Frames as they come on a busy machine: from 5 to 70 ms, the same at each run.
Frames unsteady() {
    std::mt19937 random(42);
    Frames frames;
    for (double t = 0; t < seconds;) {
        const double passed = std::min(0.005 + 0.065 * std::pow(random() / 4294967296.0, 3), seconds - t);
        frames.push_back(passed);
        t += passed;
    }
    return frames;
}

const State<double> landing{0, 0, -3};  // the character lands on its legs at 3 m/s

template <class Method, class Model, class Draw>
void variable_step(const Method& method, const Model& scene, const Frames& frames, const Draw& draw) {
    /// [variable]
    // Every frame is one step, as long as the frame.
    State state = landing;
    for (const double passed : frames) {
        state = method.step(scene, state, passed);
        draw(state);
    }
    /// [variable]
}

template <class Method, class Model, class Draw, class Observe>
void fixed_step(const Method& method, const Model& scene, const Frames& frames, double step, const Draw& draw,
                const Observe& observe) {
    /// [fixed]
    // Every frame takes the steps that are due, and draws between the last two.
    GameLoop loop(step, most_steps(step));
    State before = landing, now = landing;
    for (const double passed : frames) {
        loop.frame(passed, [&](double h) {
            before = now;
            now = method.step(scene, now, h);
            observe(now);
        });
        draw(interpolate(before, now, loop.alpha()));
    }
    /// [fixed]
}

// A motion that has blown up is drawn at the edge of the picture, and told as a million kilometres.
double within(double x, double limit) { return std::isfinite(x) ? std::clamp(x, -limit, limit) : limit; }

double hip(const State<double>& s) { return leg + within(s.x, 5); }

// How far up and down one swing goes.
struct Swing {
    double since, until = 1e9;  // s
    double low = 1e9, high = -1e9;

    void look(const State<double>& s) {
        if (s.t < since || s.t > until) return;
        low = std::min(low, within(s.x, 1e9));
        high = std::max(high, within(s.x, 1e9));
    }
    double height() const { return std::max(0.0, high - low); }
};

bool same_bits(const std::vector<State<double>>& a, const std::vector<State<double>>& b) {
    const std::size_t n = std::min(a.size(), b.size());
    const std::size_t more = std::max(a.size(), b.size()) - n;  // a step may be a rounding short
    return n > 0 && more <= 1 && std::memcmp(a.data(), b.data(), n * sizeof a[0]) == 0;
}

// One landing at one frame rate, stepped both ways.
struct Landing {
    double variable = 0, fixed = 0;     // m, the last swings
    double first = 0;                   // m, the first swing with the fixed step
    std::vector<State<double>> states;  // of the fixed step
};

template <class Method>
Landing land(const Method& method, const Settings& settings, const std::string& name, const Frames& frames,
             lab::Findings& out) {
    const auto scene = character(settings);
    Landing result;
    Swing variable{seconds - settings.period()}, fixed = variable, first{0, settings.period()};
    auto& by_frames = out.table("variable_" + name + ".tsv", {"t", "height"});
    by_frames.row({0.0, hip(landing)});
    variable_step(method, scene, frames, [&](const State<double>& drawn) {
        by_frames.row({drawn.t, hip(drawn)});
        variable.look(drawn);
    });
    auto& by_steps = out.table("fixed_" + name + ".tsv", {"t", "height"});
    fixed_step(
        method, scene, frames, settings.step,
        [&](const State<double>& drawn) {
            by_steps.row({drawn.t, hip(drawn)});
        },
        [&](const State<double>& s) {
            result.states.push_back(s);
            fixed.look(s);
            first.look(s);
        });
    result.variable = variable.height();
    result.fixed = fixed.height();
    result.first = first.height();
    std::printf("  %8s  %14.3g m  %12.3g m  %8zu\n", name.c_str(), result.variable, result.fixed, result.states.size());
    return result;
}

template <class Method>
void frame_rates(const Method& method, const Settings& settings, lab::Findings& out) {
    std::printf("  %s, the character's last oscillation with a step that is\n", Method::name);
    std::printf("  frames/s  the frame's time             fixed     steps\n");
    const Landing at_144 = land(method, settings, "144", steady(144), out);
    const Landing at_60 = land(method, settings, "60", steady(60), out);
    const Landing at_30 = land(method, settings, "30", steady(30), out);
    const Landing uneven = land(method, settings, "unsteady", unsteady(), out);

    const bool same = same_bits(at_144.states, at_60.states) && same_bits(at_144.states, at_30.states) &&
                      same_bits(at_144.states, uneven.states);
    std::printf("  with the fixed step all four find the same states%s\n",
                same ? ", bit for bit" : ": NO, THEY DIFFER");
    std::printf("  its first oscillation goes over %.4g m, its last over %.4g m: it %s\n", at_60.first, at_60.fixed,
                at_60.fixed < at_60.first ? "settles" : "grows");
    out.check("same_at_every_rate", same, "with a fixed step the states are the same bit for bit at every frame rate");
    // The first swing would go from −v/ω to v/ω.
    const double first = 2 * std::fabs(landing.v) / settings.omega();
    out.check("frame_rate_matters", at_144.variable < first && at_30.variable > first,
              "with a step as long as the frame the oscillation shrinks at 144 frames/s and grows at 30");
    if (settings.step == Settings{}.step)  // the page speaks of this step alone
        out.check("one_step_short", at_144.states.size() + 1 == at_60.states.size(),
                  "after three seconds 144 frames/s have taken one step fewer than 60");
}

// The exact motion, about the height at which the character stands.
void exact_landing(const Settings& settings, lab::Findings& out) {
    const DampedSpring legs = settings.legs();
    const double sag = gravity / (legs.omega * legs.omega);
    auto& exact = out.table("frames_exact.tsv", {"t", "height"});
    for (int i = 0; i <= 300; ++i) {
        const State s = legs.exact(State{0, landing.x + sag, landing.v}, seconds * i / 300);
        exact.row({s.t, leg + s.x - sag});
    }
    std::printf("  standing, its legs give way by %.3f m\n", sag);
    out.number("sag", sag, "m", "how far the standing character's legs give way: g/ω²");
    out.number("stands_at", leg - sag, "m", "height at which its hip comes to rest");
    // −ω² · (−g/ω²) − g: three roundings of g.
    const double force = std::fabs(acceleration(character(settings), -sag, 0.0));
    out.check("equilibrium", force < 3 * 2.3e-16 * gravity, "at g/omega^2 below rest length no force is left");
}

// What is owed and paid, in the first frames of a busy machine.
void accumulator(const Settings& settings, lab::Findings& out) {
    GameLoop loop(settings.step, most_steps(settings.step));
    auto& table = out.table("accumulator.tsv", {"clock", "simulated", "drawn"});
    State<double> before{0, 0, 0}, now{0, 0, 0};
    double clock = 0, most_off = 0;
    table.row({0.0, 0.0, 0.0});
    for (const double passed : unsteady()) {
        clock += passed;
        loop.frame(passed, [&](double h) {
            before = now;
            now = {now.t + h, now.x, now.v};
        });
        const double drawn = interpolate(before, now, loop.alpha()).t;
        table.row({1000 * clock, 1000 * loop.time(), 1000 * drawn});
        if (loop.steps() > 0) most_off = std::max(most_off, std::fabs(clock - settings.step - drawn));
        if (clock > 20 * settings.step) break;
    }
    // Some twenty sums of numbers below the clock's.
    out.check("one_step_late", most_off < 40 * 2.3e-16 * clock,
              "once there is a step, what is drawn is one step behind the player's clock, never "
              "more or less");
}

}  // namespace

void game_loop(const Settings& settings, lab::Findings& out) {
    out.section("The game loop");
    out.number("step", 1000 * settings.step, "ms", "the game loop's fixed step", 4);
    if (settings.method == "explicit_euler")
        frame_rates(explicit_euler, settings, out);
    else if (settings.method == "semi_implicit_euler")
        frame_rates(semi_implicit_euler, settings, out);
    else
        frame_rates(runge_kutta_4, settings, out);
    exact_landing(settings, out);
    accumulator(settings, out);
}
