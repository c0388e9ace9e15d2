// The undamped spring: position and velocity against time, and against each other.

#include <cmath>
#include <cstdio>
#include <vector>

#include "sections.hpp"

using namespace timestep;

namespace {

constexpr int samples = 720;  // a swing, half a degree at a time
constexpr int frames = 60;    // of the film

// By how many samples must v be shifted to the right to look most like x? The one with the largest
// correlation Σ x(t) v(t − lag) wins.
int lag_of_velocity(const std::vector<double>& x, const std::vector<double>& v) {
    const int n = static_cast<int>(x.size());
    int best = 0;
    double best_sum = -1e300;
    for (int lag = 0; lag < n; ++lag) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += x[i] * v[(i - lag + n) % n];
        if (sum > best_sum) {
            best_sum = sum;
            best = lag;
        }
    }
    return best;
}

void oscillation(const Spring<double>& spring, const State<double>& start, double period, lab::Findings& out) {
    auto& table = out.table("oscillation.tsv", {"t", "x", "v_over_omega"});
    for (int i = 0; i <= 2 * samples; i += 4) {
        const State s = spring.exact(start, period * i / samples);
        table.row({s.t, s.x, s.v / spring.omega});
    }
    std::vector<double> x, v;
    for (int i = 0; i < samples; ++i) {
        const State s = spring.exact(start, period * i / samples);
        x.push_back(s.x);
        v.push_back(s.v);
    }
    const double phase = 360.0 * lag_of_velocity(x, v) / samples;
    std::printf("  velocity runs %g degrees ahead of position\n", phase);
    out.number("phase", phase, "°", "by how much velocity runs ahead of position");
    out.check("quarter_turn", phase == 90, "velocity runs a quarter of a turn ahead of position");
}

// The area inside the path, by the surveyor's formula: above zero counter-clockwise, below
// clockwise.
double signed_area(const Spring<double>& spring, const State<double>& start, double period) {
    double twice = 0;
    for (int i = 0; i < samples; ++i) {
        const State a = spring.exact(start, period * i / samples);
        const State b = spring.exact(start, period * (i + 1) / samples);
        twice += (a.x * b.v - b.x * a.v) / spring.omega;
    }
    return twice / 2;
}

void circle(const Spring<double>& spring, const State<double>& start, double period, lab::Findings& out) {
    auto& table = out.table("portrait.tsv", {"t", "x", "v_over_omega"});
    for (int i = 0; i <= samples; i += 4) {
        const State s = spring.exact(start, period * i / samples);
        table.row({s.t, s.x, s.v / spring.omega});
    }
    // An arrow every eighth of a swing, along the rate of change.
    auto& arrows = out.table("portrait_arrows.tsv", {"x", "v_over_omega", "dx", "dv"});
    for (int i = 1; i <= 8; ++i) {
        const State s = spring.exact(start, period * (i - 0.5) / 8);
        const Rate<double> r = rate(spring, s);
        const double scale = 0.3 / spring.omega;
        arrows.row({s.x, s.v / spring.omega, scale * r.x, scale * r.v / spring.omega});
    }
    const double area = signed_area(spring, start, period);
    const State end = spring.exact(start, period);
    const double missed = std::hypot(end.x - start.x, (end.v - start.v) / spring.omega);
    std::printf("  the portrait is a circle of area %.4f m^2, walked %s\n", std::fabs(area),
                area < 0 ? "clockwise" : "COUNTER-CLOCKWISE");
    std::printf("  after one period it misses its start by %.1e m\n", missed);
    out.number("portrait_missed", missed, "m", "distance from the start after one period", 2);
    out.check("clockwise", area < 0, "the state goes clockwise");
    // ωt = 2π is rounded by 2π ε/2 and sine and cosine by ε, all times the amplitude.
    out.check("closed", missed < 8 * 2.3e-16 * start.x, "after one period the state is back at its start");
}

// The film: a strip of the last one and a half swings beside the portrait, one swing long.
void film(const Spring<double>& spring, const State<double>& start, double period, lab::Findings& out) {
    auto& table = out.table("portrait_film.tsv", {"t", "x", "v_over_omega"});
    for (int i = -3 * frames / 2; i <= frames; ++i) {
        const State s = spring.exact(start, period * i / frames);
        table.row({s.t / period, s.x, s.v / spring.omega});
    }
}

}  // namespace

void portrait(const Settings& settings, lab::Findings& out) {
    out.section("A spring and its portrait");
    const Spring spring(settings.omega());
    const State start{0, dip, 0.0};
    oscillation(spring, start, settings.period(), out);
    circle(spring, start, settings.period(), out);
    film(spring, start, settings.period(), out);
}
