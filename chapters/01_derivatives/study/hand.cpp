// Another player's hand swings to and fro. Its position comes frame by frame, rounded to a grid to
// save bandwidth. Which two frames make the best velocity?

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include <timestep/difference_error.hpp>
#include <timestep/differences.hpp>

#include "derivatives.hpp"

using namespace timestep;

namespace {

// The hand moves by half a metre to each side, at up to 1 m/s.
constexpr double amplitude = 0.5;  // m
constexpr double omega = 2;        // rad/s
double position(double t) { return amplitude * std::sin(omega * t); }
double velocity(double t) { return amplitude * omega * std::cos(omega * t); }
constexpr double most_acceleration = amplitude * omega * omega;  // m/s²
constexpr double most_jerk = most_acceleration * omega;          // the acceleration's slope, m/s³

/// [received]
// The hand as it arrives: a function of time like any other.
struct Received {
    double grid;  // m
    double operator()(double t) const {
        const double lines = position(t) / grid;
        return grid * std::round(lines);
    }
};
/// [received]

// The largest error of two frames, taken for the velocity at the later one or in between.
struct Errors {
    double now = std::numeric_limits<double>::infinity();
    double between = std::numeric_limits<double>::infinity();
};

Errors largest_errors(const Received& received, double h, int frames_apart) {
    constexpr double watched = 60;  // s
    Errors largest{0, 0};
    for (int i = 0; i < watched / h; ++i) {
        /// [two_frames]
        const double gap = frames_apart * h;
        const double t = i * h;
        const double middle = t - gap / 2;
        const double now = backward_difference(received, t, gap);
        const double between = central_difference(received, middle, gap / 2);
        /// [two_frames]
        largest.now = std::max(largest.now, std::fabs(now - velocity(t)));
        largest.between = std::max(largest.between, std::fabs(between - velocity(middle)));
    }
    return largest;
}

void draw_hand(const Received& received, double h, int frames_apart, lab::Findings& out) {
    auto& table = out.table("hand.tsv", {"t", "exact", "one_frame", "t_between", "between"});
    const double gap = frames_apart * h;
    for (int i = 0; i * h <= 3.2; ++i) {
        const double t = i * h, middle = t - gap / 2;
        table.row({t, velocity(t), backward_difference(received, t, h), middle,
                   central_difference(received, middle, gap / 2)});
    }
}

// N06: velocity is the slope of the position, acceleration the slope of the velocity.
void dots(double h, lab::Findings& out) {
    /// [dots]
    const auto dot = [h](auto x) { return [x, h](double t) { return central_difference(x, t, h); }; };
    const auto x_dot = dot(position);
    const auto x_dot_dot = dot(x_dot);
    /// [dots]
    const double t = 0.5;
    std::printf("without rounding, at %g s: x = %.4f m, its slope is %.4f m/s,\n", t, position(t), x_dot(t));
    std::printf("the slope's slope %.4f m/s^2\n", x_dot_dot(t));
    out.number("dots_t", t, "s", "a moment of the hand's swing");
    out.number("dots_v", x_dot(t), "m/s", "velocity there, a difference of positions", 4);
    out.number("dots_v_exact", velocity(t), "m/s", "velocity there, exactly", 4);
    out.number("dots_a", x_dot_dot(t), "m/s²", "acceleration, a difference of velocities", 4);
    out.number("dots_a_exact", -omega * omega * position(t), "m/s²", "acceleration there, exactly", 4);
}

}  // namespace

void frames(const Settings& settings, lab::Findings& out) {
    const Received received{settings.grid};
    const double h = 1 / settings.rate;
    const double noise = settings.grid / 2;

    out.section("Velocity from frames");
    std::printf("a hand swings at up to 1 m/s; its position comes %g times a second,\n", settings.rate);
    std::printf("rounded to %g m; largest error of (x2 - x1)/gap, in m/s, as the velocity\n", settings.grid);
    std::printf("  frames apart       now    in between\n");
    auto& table = out.table("gap.tsv", {"frames", "now", "now_bound", "between", "between_bound"});
    Errors one_frame, best;
    int best_now = 0, best_between = 0;
    bool bounded = true;
    const int most_frames = static_cast<int>(0.5 * settings.rate);
    for (int n = 1; n <= most_frames; ++n) {
        const double gap = n * h;
        const Errors errors = largest_errors(received, h, n);
        const Errors bound{error_bound(backward_difference, gap, noise, most_acceleration),
                           error_bound(central_difference, gap / 2, noise, most_jerk)};
        // The arithmetic itself rounds positions below 1 m, and their times, by less than 1e-14.
        bounded = bounded && errors.now <= bound.now + 1e-14 / gap && errors.between <= bound.between + 1e-14 / gap;
        if (n == 1) one_frame = errors;
        if (errors.now < best.now) best.now = errors.now, best_now = n;
        if (errors.between < best.between) best.between = errors.between, best_between = n;
        table.row({double(n), errors.now, bound.now, errors.between, bound.between});
        if (n == 1 || n == 2 || n == 4 || n == 8 || n == 15 || n == most_frames)
            std::printf("  %12d   %7.3f   %11.3f\n", n, errors.now, errors.between);
    }
    const double now_predicted = best_step(backward_difference, noise, most_acceleration) / h;
    const double between_predicted = 2 * best_step(central_difference, noise, most_jerk) / h;
    std::printf("best gap in frames: %d for now (predicted %.1f),\n", best_now, now_predicted);
    std::printf("%d for in between (predicted %.1f)\n", best_between, between_predicted);

    out.number("grid_mm", 1000 * settings.grid, "mm", "the positions are rounded to this");
    out.number("hand_speed", velocity(0), "m/s", "the hand moves at up to this");
    out.number("hand_amplitude", amplitude, "m", "the hand swings by this to each side");
    out.number("hand_omega", omega, "rad/s", "angular frequency of its oscillation");
    out.number("hand_acceleration", most_acceleration, "m/s²", "the hand's largest acceleration");
    out.number("hand_jerk", most_jerk, "m/s³", "the largest slope of its acceleration");
    out.number("rate", settings.rate, "", "positions a second");
    out.number("one_frame_error", one_frame.now, "m/s", "largest error, neighbouring frames", 2);
    out.number("now_frames", best_now, "", "best gap for the velocity now, frames");
    out.number("now_predicted", now_predicted, "", "the same, predicted", 2);
    out.number("now_error", best.now, "m/s", "largest error with that gap", 2);
    out.number("between_frames", best_between, "", "best gap for the moment in between, frames");
    out.number("between_predicted", between_predicted, "", "the same, predicted", 2);
    out.number("between_error", best.between, "m/s", "largest error with that gap", 2);
    out.number("between_late", 500 * best_between * h, "ms", "how late that velocity is", 3);
    out.check("frames_bounded", bounded, "no error is larger than predicted, at any gap up to half a second");
    // The predicted gap, in whole frames, against the best one.
    const auto at = [&](double frames) {
        const long n = std::lround(std::min(frames, double(most_frames)));
        return largest_errors(received, h, static_cast<int>(std::max(n, 1L)));
    };
    out.check("gaps_predicted",
              at(now_predicted).now <= 1.1 * best.now && at(between_predicted).between <= 1.1 * best.between,
              "the predicted gaps err at most a tenth more than the best ones");
    out.check("one_frame_is_worse", one_frame.now > 2 * best.now,
              "neighbouring frames err more than twice as much as the best gap");
    out.check("between_is_better", best.between < best.now / 2,
              "taken for the velocity in between, the best error is less than half as large");
    draw_hand(received, h, best_between, out);
    dots(h, out);
}
