// A beach ball bounces: what a collision inside the run does to the order of a method.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods/midpoint.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/scene.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr double restitution = 0.8;  // the speed after the bounce over the speed before

constexpr double in_the_air = 0.4, after_landing = 0.9;  // s; the ball lands after some 0.6 s

const Scene ball{Projectile(-9.81), Drag<double>::from_terminal_speed(4.0, 9.81)};

/// [bounce]
// As games do it: step, and when the ball has sunk into the ground, put it back and
// turn it round.
template <class Method>
State<double> step_and_bounce(const Method& method, State<double> state1, double h) {
    State state2 = method.step(ball, state1, h);
    if (state2.x < 0) {
        state2.x = -restitution * state2.x;
        state2.v = -restitution * state2.v;
    }
    return state2;
}
/// [bounce]

template <class Method>
double height_after(const Method& method, double drop, double seconds, long steps) {
    State state{0, drop, 0.0};
    for (long i = 0; i < steps; ++i) state = step_and_bounce(method, state, seconds / steps);
    return state.x;
}

// The true height: small RK4 steps, the last one before the ground cut by bisection to end on it.
double true_height(double drop, double seconds) {
    State state{0, drop, 0.0};
    while (state.t < seconds) {
        double h = std::min(1e-3, seconds - state.t);
        State next = runge_kutta_4.step(ball, state, h);
        if (next.x < 0 && state.v < 0) {
            double before = 0, after = h;
            for (int i = 0; i < 60; ++i) {
                const double middle = (before + after) / 2;
                (runge_kutta_4.step(ball, state, middle).x < 0 ? after : before) = middle;
            }
            next = runge_kutta_4.step(ball, state, before);
            next.x = 0;
            next.v = -restitution * next.v;
            h = before;
        }
        state = next;
        if (seconds - state.t < 1e-12) break;
    }
    return state.x;
}

// Where in its step the ball meets the ground decides the error of a single run, so this is the
// mean over 60 heights from which the ball is dropped.
template <class Method>
double mean_error(const Method& method, double seconds, long steps) {
    double sum = 0;
    const int drops = 60;
    for (int i = 0; i < drops; ++i) {
        const double drop = 1 + 0.3 * i / drops;
        sum += std::fabs(height_after(method, drop, seconds, steps) - true_height(drop, seconds));
    }
    return sum / drops;
}

template <class Method>
double order(const Method& method, bool bounce, lab::Findings& out) {
    const double seconds = bounce ? after_landing : in_the_air;
    auto& table =
        out.table(std::string(bounce ? "bounce_" : "fall_") + lab::id(method.name) + ".tsv", {"step", "error"});
    std::vector<double> h, mean;
    for (long steps = bounce ? 32 : 16; steps <= (bounce ? 2048 : 256); steps *= 2) {
        h.push_back(seconds / steps), mean.push_back(mean_error(method, seconds, steps));
        table.row({h.back(), mean.back()});
    }
    return measured_order(h, mean);
}

template <class Method>
double compare(const Method& method, lab::Findings& out) {
    const double fall = order(method, false, out), bounce = order(method, true, out);
    const double at_60 = mean_error(method, after_landing, std::lround(60 * after_landing));
    std::printf("  %-20s order %5.2f falling, %5.2f bounced; at 60 Hz %.1f mm off\n", Method::name, fall, bounce,
                1000 * at_60);
    const std::string id = lab::id(method.name);
    out.number("fall_order_" + id, fall, "", "measured order without a bounce");
    out.number("bounce_order_" + id, bounce, "", "measured order with a bounce");
    out.check("bounce_order_" + id, std::fabs(fall - Method::order) < 0.1 && std::fabs(bounce - 1) < 0.1,
              std::string(method.name) + " has its order while the ball falls, and order one once it has bounced");
    return at_60;
}

}  // namespace

// At 60 Hz, the error in the frames from `from` to `to`, on the mean over the frames and the drops.
template <class Method>
double mean_over_frames(const Method& method, double from, double to) {
    double sum = 0;
    const long first = std::lround(60 * from), last = std::lround(60 * to);
    for (long frame = first; frame <= last; ++frame) sum += mean_error(method, frame / 60.0, frame);
    return sum / double(last - first + 1);
}

// When the true ball meets the ground: RK4 in steps of 0.1 ms, and between the last two a line.
double true_landing(double drop) {
    State state{0, drop, 0.0};
    for (;;) {
        const State next = runge_kutta_4.step(ball, state, 1e-4);
        if (next.x < 0) return state.t + 1e-4 * state.x / (state.x - next.x);
        state = next;
    }
}

// How late a ball is turned round at 60 Hz, in seconds: over the drops the first, the mean and the
// last.
struct Late {
    double least = 1, mean = 0, most = -1;
};

template <class Method>
Late turned_late(const Method& method) {
    Late late;
    const int drops = 60;
    for (int i = 0; i < drops; ++i) {
        State state{0, 1 + 0.3 * i / drops, 0.0};
        const double landing = true_landing(state.x);
        while (state.x >= 0) state = method.step(ball, state, 1.0 / 60);
        const double by = state.t - landing;
        late.least = std::min(late.least, by), late.most = std::max(late.most, by), late.mean += by / drops;
    }
    return late;
}

void bounces(const Settings&, lab::Findings& out) {
    out.section("A bouncing ball");
    compare(semi_implicit_euler, out);
    compare(midpoint, out);
    compare(runge_kutta_4, out);
    const double settled = 0.8, end = 1.6;
    const double cheap = mean_over_frames(semi_implicit_euler, settled, end);
    const double dear = mean_over_frames(runge_kutta_4, settled, end);
    std::printf(
        "  at 60 Hz, from %g to %g s after the drop: semi-implicit %.1f mm off on the average,\n"
        "  Runge-Kutta 4 %.1f mm\n",
        settled, end, 1000 * cheap, 1000 * dear);
    out.number("bounce_from", settled, "s", "begin of the frames compared");
    out.number("bounce_to", end, "s", "end of the frames compared");
    out.number("bounce_mean_semi", 1000 * cheap, "mm", "mean error in these frames", 2);
    out.number("bounce_mean_rk4", 1000 * dear, "mm", "mean error in these frames", 2);
    // A little sooner the ball is elsewhere in its flight, and the ranking is another.
    const double sooner = 0.6;
    const double cheap_sooner = mean_error(semi_implicit_euler, sooner, std::lround(60 * sooner));
    const double dear_sooner = mean_error(runge_kutta_4, sooner, std::lround(60 * sooner));
    std::printf("  at 60 Hz, %g s after the drop: semi-implicit %.1f mm off, Runge-Kutta 4 %.1f mm\n", sooner,
                1000 * cheap_sooner, 1000 * dear_sooner);
    out.number("bounce_sooner", sooner, "s", "an earlier moment");
    out.number("bounce_sooner_semi", 1000 * cheap_sooner, "mm", "mean error at the earlier moment", 2);
    out.number("bounce_sooner_rk4", 1000 * dear_sooner, "mm", "mean error at the earlier moment", 2);
    const Late cheap_late = turned_late(semi_implicit_euler), dear_late = turned_late(runge_kutta_4);
    std::printf(
        "  turned round late by %.1f to %.1f ms, on the mean %.1f: semi-implicit; by %.1f to %.1f, "
        "%.1f: RK4\n",
        1000 * cheap_late.least, 1000 * cheap_late.most, 1000 * cheap_late.mean, 1000 * dear_late.least,
        1000 * dear_late.most, 1000 * dear_late.mean);
    out.number("bounce_early_semi", -1000 * cheap_late.least, "ms", "by how much it turns too early, at the most", 2);
    out.number("bounce_late_semi", 1000 * cheap_late.most, "ms", "and too late", 2);
    out.number("bounce_late_rk4", 1000 * dear_late.mean, "ms", "by how much RK4's ball turns too late, on the mean", 2);
    out.check("bounce_turned",
              dear_late.least > 0 && cheap_late.least < -1e-3 && cheap_late.most > 1e-3 &&
                  std::fabs(cheap_late.mean) < dear_late.mean / 2,
              "in all sixty drops RK4's ball is turned round too late; semi-implicit Euler's now "
              "too early, now too late, on "
              "the mean by less than half as much");
    out.check("bounce_depends", dear_sooner < cheap_sooner,
              "when the ball lands RK4 at 60 Hz is closer than semi-implicit Euler");
    out.check("bounce_rk4_no_better", dear >= cheap,
              "in the frames after the bounce, RK4 at 60 Hz is no closer on the average than "
              "semi-implicit Euler");
}
