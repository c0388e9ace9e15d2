// What goes wrong, on purpose: frames that take turns, steps that cost more than they simulate, and
// a clock that adds.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/game_loop.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>

#include "sections.hpp"

using namespace timestep;

namespace {

// Semi-implicit Euler holds this spring at 60 frames a second, and at 30. When they take turns, it
// blows up: with a = ωh and b = 2ωh the matrix of two steps has determinant 1 and trace
// 2 − (a + b)² + a²b², and below −2 an eigenvalue is beyond −1: for ωh from 0.781 to 1.281.
void taking_turns(lab::Findings& out) {
    const double h = 1.0 / 60, omega = 50;
    const Spring spring(omega);
    auto& table = out.table("taking_turns.tsv", {"t", "steady_60", "steady_30", "turns"});
    State<double> at_60{0, 1, 0}, at_30 = at_60, turns = at_60;
    const auto amplitude = [&](const State<double>& s) { return std::hypot(s.x, s.v / omega); };
    const int rounds = 10;  // of a tenth of a second: six short frames, three long, or two of each
    double most_60 = 1, most_30 = 1;
    for (int i = 0; i <= rounds; ++i) {
        table.row({turns.t, amplitude(at_60), amplitude(at_30), amplitude(turns)});
        if (i == rounds) break;
        for (int k = 0; k < 6; ++k) {
            at_60 = semi_implicit_euler.step(spring, at_60, h);
            most_60 = std::max(most_60, amplitude(at_60));
        }
        for (int k = 0; k < 3; ++k) {
            at_30 = semi_implicit_euler.step(spring, at_30, 2 * h);
            most_30 = std::max(most_30, amplitude(at_30));
        }
        for (int k = 0; k < 2; ++k) {
            turns = semi_implicit_euler.step(spring, turns, h);
            turns = semi_implicit_euler.step(spring, turns, 2 * h);
        }
    }
    const double grown = amplitude(turns);
    const double a = omega * h, b = 2 * a;
    const double trace = 2 - (a + b) * (a + b) + a * a * b * b;
    const double predicted = std::sqrt(trace * trace / 4 - 1) - trace / 2;
    std::printf(
        "  the oscillation of a spring of %g rad/s grows to at most\n"
        "    %8.1f times at a steady 60 frames/s\n"
        "    %8.1f times at a steady 30 frames/s\n"
        "    %8.0f times in %.2f s when frames take turns\n",
        omega, most_60, most_30, grown, turns.t);
    const double root = std::sqrt(17.0);  // of 4u² − 9u + 4 = 0, u = (ωh)²
    out.number("turns_low", std::sqrt((9 - root) / 8), "", "taking turns is fatal from this omega h on");
    out.number("turns_high", std::sqrt((9 + root) / 8), "", "up to this");
    out.number("steady_most", std::max(most_60, most_30), "", "largest amplitude at a steady rate, of one at the start",
               2);
    out.number("turns_omega", omega, "rad/s", "the spring that cannot stand frames taking turns");
    out.number("turns_short", 1000 * h, "ms", "the short frames", 3);
    out.number("turns_long", 2000 * h, "ms", "and the long ones", 3);
    out.number("turns_growth", predicted, "", "by this each pair of frames multiplies the amplitude");
    out.number("turns_pairs", 2 * rounds, "", "pairs of frames in the run");
    out.number("turns_power", std::pow(predicted, 2 * rounds), "", "growth that many pairs make", 2);
    out.number("turns_grown", grown, "", "amplitude after the run, of one at the start", 2);
    out.number("turns_seconds", turns.t, "s", "length of the run");
    out.number("turns_lean", grown / std::pow(predicted, 2 * rounds), "",
               "one over the other: what the first pairs add", 2);
    out.check("steady_holds", most_60 < 3 && most_30 < 3, "at a steady rate the spring stays bounded");
    const double lean = grown / std::pow(predicted, 2 * rounds);
    out.check("turns_blow_up", grown > 1e3 && lean > 1 && lean < 3,
              "with frames taking turns it blows up, by one to three times what the factor of a "
              "pair makes");
}

// A step costs a fifth more time than it simulates. Each frame then owes a fifth more than the
// last.
void spiral_of_death(lab::Findings& out) {
    const double h = 1.0 / 60, dear = 1.2, cost = dear * h, drawing = 0.004;
    GameLoop free(h, 1000000), capped(h, 5);
    auto& table = out.table("spiral_of_death.tsv", {"frame", "no_cap", "cap"});
    double a = h, b = h;
    const int frames = 30;
    double speed = 0;  // of the game with the cap, in the last frame: time simulated over time passed
    for (int i = 0;; ++i) {
        table.row({double(i), 1000 * a, 1000 * b});
        if (i == frames) break;
        const double before = capped.time(), passed = b;
        a = drawing + cost * static_cast<double>(free.frame(a, [](double) {}));
        b = drawing + cost * static_cast<double>(capped.frame(b, [](double) {}));
        speed = (capped.time() - before) / passed;
    }
    std::printf(
        "  steps that cost %g times what they simulate: frame %d takes %.1f s\n"
        "  without a cap; with one %.0f ms, at %.0f %% of the game's speed\n",
        dear, frames, a, 1000 * b, 100 * speed);
    out.number("death_step", 1000 * h, "ms", "the step of the spiral of death", 4);
    out.number("death_drawing", 1000 * drawing, "ms", "what a frame takes for drawing");
    out.number("death_cost", dear, "", "what a step costs, over what it simulates");
    out.number("death_frame", a, "s", "how long the last frame of the run takes without a cap", 2);
    out.number("capped_frame", 1000 * b, "ms", "and with a cap of five steps");
    out.number("death_frames", frames, "", "number of that frame");
    out.number("capped_speed", 100 * speed, "%", "speed of the game in a steady frame with the cap", 2);
    out.check("spiral_grows", a > 10 * b, "without the cap frames take longer and longer");
    out.check("cap_holds", b < drawing + 5.01 * cost, "with the cap no frame takes more than five steps");
    // Frames are steady: five steps of h in the time of one frame, but for the roundoff of a clock.
    out.check("capped_speed_steady", std::fabs(speed - 5 * h / b) < 1e-12,
              "with the cap the game runs at the speed of five steps a frame");
}

// A clock in float to which 1/60 s is added, and one that multiplies.
void adding_clock(lab::Findings& out) {
    const float h = 1.0f / 60;
    float added = 0;
    const long steps = 60L * 60 * 60;  // an hour
    for (long i = 0; i < steps; ++i) added += h;
    const double hour = 3600;
    const double counted = static_cast<float>(steps) * h;
    std::printf(
        "  after an hour a float clock that adds is %.1f s off,\n"
        "  one that counts %.1e s\n",
        std::fabs(added - hour), std::fabs(counted - hour));
    out.number("added_clock", std::fabs(added - hour), "s", "error of an adding float clock after an hour");
    out.number("counted_clock", 1000 * std::fabs(counted - hour), "ms", "error of a counting one", 2);
    out.check("counting_better", std::fabs(counted - hour) < std::fabs(added - hour),
              "counting steps keeps better time than adding them up");
}

}  // namespace

void break_it(const Settings&, lab::Findings& out) {
    out.section("Break it");
    taking_turns(out);
    spiral_of_death(out);
    adding_clock(out);
}
