// The same program, other bits: what a compiler may do with one line of a step, and what becomes of
// it. And places so far away that a float has no number for the next step.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "sections.hpp"

namespace {

constexpr double h = 1.0 / 60;

/// [builds]
// The product is rounded, and then the sum.
double as_written(double y, double f) { return y + h * f; }

// Contraction: product and sum are rounded once.
double fused(double y, double f) { return std::fma(h, f, y); }
/// [builds]

using Line = double (*)(double, double);

// A ball falls among three round pegs between two walls, and loses nothing when it bounces.
// Semi-implicit Euler.
struct Pinball {
    double x = -0.1, y = 2, vx = 0.7, vy = 0;

    void step(Line line) {
        vy = line(vy, -gravity);
        x = line(x, vx);
        y = line(y, vy);
        for (const auto& [px, py] : {std::pair{-0.5, 0.5}, {0.5, 0.5}, {0.0, 1.0}}) {
            const double dx = x - px, dy = y - py, square = dx * dx + dy * dy, inwards = dx * vx + dy * vy;
            if (square > 0.2 * 0.2 || inwards > 0) continue;
            vx -= 2 * inwards / square * dx;
            vy -= 2 * inwards / square * dy;
        }
        if ((x > 1 && vx > 0) || (x < -1 && vx < 0)) vx = -vx;
        if (y < 0 && vy < 0) vy = -vy;
    }
};

// The same ball on a spring, whose equation is linear.
struct OnSpring {
    double x = -0.1, y = 2, vx = 0.7, vy = 0;

    void step(Line line) {
        const double omega = 10;
        vx = line(vx, -omega * omega * x);
        vy = line(vy, -omega * omega * y - gravity);
        x = line(x, vx);
        y = line(y, vy);
    }
};

template <class Scene>
std::vector<Scene> recorded(Line line, int steps) {
    std::vector<Scene> states{Scene{}};
    for (int i = 0; i < steps; ++i) states.push_back(states.back()), states.back().step(line);
    return states;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <class Scene>
int first_difference(const std::vector<Scene>& here, const std::vector<Scene>& there) {
    for (std::size_t i = 0; i < here.size(); ++i) {
        const Scene &a = here[i], &b = there[i];
        if (!same_bits(a.x, b.x) || !same_bits(a.y, b.y) || !same_bits(a.vx, b.vx) || !same_bits(a.vy, b.vy))
            return static_cast<int>(i);
    }
    return -1;
}

template <class Scene>
double apart(const std::vector<Scene>& here, const std::vector<Scene>& there, std::size_t i) {
    return std::hypot(here[i].x - there[i].x, here[i].y - there[i].y);
}

void two_builds(lab::Findings& out) {
    const int steps = 15 * 60;
    const auto ball = recorded<Pinball>(as_written, steps), ball_fused = recorded<Pinball>(fused, steps);
    const auto spring = recorded<OnSpring>(as_written, steps), spring_fused = recorded<OnSpring>(fused, steps);
    auto& table = out.table("other_bits.tsv", {"t", "pinball", "spring"});
    double ball_most = 0, spring_most = 0;
    int seen = -1;
    for (int i = 0; i <= steps; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double balls = apart(ball, ball_fused, k), springs = apart(spring, spring_fused, k);
        if (i % 3 == 0) table.row({i * h, balls, springs});
        if (seen < 0 && balls > 0.01) seen = i;
        ball_most = std::max(ball_most, balls);
        spring_most = std::max(spring_most, springs);
    }
    const int first = first_difference(ball, ball_fused);
    std::printf(
        "  two builds of one program: step %d is the first whose bits differ; after %.1f s the "
        "balls are\n"
        "    1 cm apart, and up to %.1f m later on; on a spring they stay within %.0e m\n",
        first, seen * h, ball_most, spring_most);
    out.number("bits_first", first, "", "the first step whose bits differ between two builds of one program");
    out.number("bits_seen", seen * h, "s", "after this the balls are a centimetre apart", 2);
    out.number("bits_apart", ball_most, "m", "how far apart they are at most", 2);
    out.number("bits_spring", spring_most, "m", "and on a spring", 2);
    out.check("builds_part", first > 0 && ball_most > 1, "among pegs two builds of one program play two games");
    out.check("spring_stays", first_difference(spring, spring_fused) > 0 && spring_most < 1e-12,
              "on a linear spring other bits stay roundoff");
}

std::string rounded(double value) {
    char text[24];
    std::snprintf(text, sizeof text, "%.3f", value);
    return text;
}

// Someone walks away from the origin at 1 m/s, a float for the place: how fast, seen over ten
// seconds?
void far_away(lab::Findings& out) {
    auto& table = out.table("far_away.tsv", {"distance (km)", "next float (mm)", "walks at (m/s)"});
    const float step = static_cast<float>(h);
    double at_300 = 0, at_600 = 0;
    for (const float km : {1.f, 10.f, 50.f, 100.f, 300.f, 600.f}) {
        const float start = km * 1000;
        float x = start;
        for (int i = 0; i < 600; ++i) x += step * 1.0f;
        const double speed = (double(x) - start) / 10;
        table.row({km, rounded(1000 * (double(std::nextafter(start, 1e9f)) - start)), rounded(speed)});
        if (km == 300) at_300 = speed;
        if (km == 600) at_600 = speed;
    }
    // The same walk in a cell of its own: whole kilometres as an integer, the rest as a float.
    int cell = 600;
    float rest = 0;
    for (int i = 0; i < 600; ++i) {
        rest += step * 1.0f;
        if (rest >= 1000) ++cell, rest -= 1000;
    }
    const double in_cells = (1000.0 * (cell - 600) + rest) / 10;
    std::printf(
        "  who walks at 1 m/s goes at %.3f m/s 300 km from the origin, at %.3f beyond 600; in "
        "cells %.4f\n",
        at_300, at_600, in_cells);
    out.number("walk_300", at_300, "m/s", "speed of a walk at 1 m/s in float, 300 km from the origin", 4);
    out.check("walk_stops", at_600 == 0, "at 600 km a float stands still");
    out.check("walk_in_cells", std::fabs(in_cells - 1) < 1e-4, "in cells of a kilometre it goes on at its speed");
}

}  // namespace

void other_bits(const Settings&, lab::Findings& out) {
    out.section("The same program, other bits");
    two_builds(out);
    far_away(out);
}
