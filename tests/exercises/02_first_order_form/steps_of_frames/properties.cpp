#include "steps_of_frames.hpp"

#include "property.hpp"

EXERCISE(steps_of_frames);

namespace {

// All times are multiples of 1/1024 s: they add and subtract without rounding.
constexpr double tick = 1.0 / 1024;

std::vector<double> draw_frames(Draw& draw, int count, int longest, double unit = tick) {
    std::vector<double> frames;
    for (int i = 0; i < count; ++i) frames.push_back(draw.integer(0, longest) * unit);
    return frames;
}

// At first a few frames of some quarters of a second, which can be worked out by hand.
double unit_of(int i) { return i < 15 ? 0.25 : tick; }
int draw_ticks(Draw& draw, int i) { return i < 15 ? draw.integer(2, 4) : draw.integer(5, 30); }

// About a picosecond, of which hours add and subtract without rounding.
constexpr double fine_tick = 0x1p-40;

double draw_time(Draw& draw, double low, double high) {
    return std::floor(draw.real(low, high) / fine_tick) * fine_tick;
}

}  // namespace

PROPERTY("there is one number for each frame, from zero to the cap") {
    Draw draw;
    REQUIRE(learner({}, 0.5, 5).empty());
    for (int i = 0; i < 30; ++i) {
        const int ticks = draw_ticks(draw, i), most = draw.integer(1, i < 15 ? 3 : 6);
        const auto frames = draw_frames(draw, draw.integer(1, i < 15 ? 5 : 40), 4 * ticks, unit_of(i));
        const auto steps = learner(frames, ticks * unit_of(i), most);
        REQUIRE(steps.size() == frames.size());
        for (const int n : steps) {
            REQUIRE(n >= 0);
            REQUIRE(n <= most);
        }
    }
}

PROPERTY("below the cap the simulation is never ahead of the clock, and less than a step behind") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const int ticks = draw_ticks(draw, i);
        const double step = ticks * unit_of(i);
        const auto frames = draw_frames(draw, i < 15 ? 2 + i / 4 : 40, 4 * ticks, unit_of(i));
        const auto steps = learner(frames, step, 5);
        REQUIRE(steps.size() == frames.size());
        double behind = 0;
        for (std::size_t k = 0; k < frames.size(); ++k) {
            behind += frames[k] - steps[k] * step;
            REQUIRE(behind >= 0);
            REQUIRE(behind < step);
        }
    }
}

// Every other time it is a bit beyond single precision, but larger than a nanosecond.
PROPERTY("a step that lacks the last bit has to wait, and one that is owed to the last bit comes") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double step = draw_time(draw, 0.5, 1) * (i % 2 == 0 ? 1 : 0x1p-7);
        const double bit = i % 2 == 0 ? 0x1p-27 : 0x1p-47, short_of = step - bit;
        const std::vector<double> frames{short_of, bit, short_of, 0, bit, step + short_of, bit};
        REQUIRE(learner(frames, step, draw.integer(2, 6)) == std::vector<int>{0, 1, 0, 0, 1, 1, 1});
        // Short by the last bit that a double has: both parts and their sum are exact.
        const double nearly = std::nextafter(step, 0.0);
        REQUIRE(learner({nearly, step - nearly}, step, 4) == std::vector<int>{0, 1});
    }
}

PROPERTY("to the last bit the simulation is never ahead of the clock, nor behind it by a step") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double step = draw_time(draw, 0.001, 0.1);
        std::vector<double> frames;
        for (int k = 0; k < 40; ++k) frames.push_back(draw_time(draw, 0, 4 * step));
        const auto steps = learner(frames, step, 5);
        REQUIRE(steps.size() == frames.size());
        double behind = 0;
        for (std::size_t k = 0; k < frames.size(); ++k) {
            behind += frames[k] - steps[k] * step;
            REQUIRE(behind >= 0);
            REQUIRE(behind < step);
        }
    }
}

// Before the hitch `early` ticks are owed; `hitch` is beyond the cap. Behind it, frames of one tick
// come: the one that fills up the step takes it. The first hitch is longer: that tells a cap that
// is off by one from no cap.
PROPERTY("after a hitch whole steps are dropped, and what is owed of the next step is kept") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const int ticks = draw_ticks(draw, i), most = draw.integer(1, i < 15 ? 3 : 6);
        const double unit = unit_of(i);
        const int early = draw.integer(1, ticks - 1);
        const int dropped = draw.integer(i == 0 ? 2 : 1, 9);
        const int hitch = (most + dropped) * ticks + draw.integer(0, ticks - 1);
        std::vector<double> frames{early * unit, hitch * unit};
        frames.resize(2 + 2 * static_cast<std::size_t>(ticks), unit);
        const auto steps = learner(frames, ticks * unit, most);
        REQUIRE(steps.size() == frames.size());
        REQUIRE(steps[0] == 0);
        REQUIRE(steps[1] == most);
        int owed = (early + hitch) % ticks;
        for (std::size_t k = 2; k < frames.size(); ++k) {
            owed = (owed + 1) % ticks;
            REQUIRE(steps[k] == (owed == 0 ? 1 : 0));
        }
    }
}

// Exact to the bit: steps from a nanosecond to a day, and frames of some of them and a part.
PROPERTY("steps may last nanoseconds or days: the rule is the same for them") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const double unit = std::pow(2, draw.integer(-30, 12));
        const int ticks = draw.integer(1, 30), most = draw.integer(1, i % 2 == 0 ? 3 : 100);
        std::vector<double> frames;
        for (int k = 0; k < 20; ++k) frames.push_back(draw.integer(0, (i % 4 < 2 ? 3 : 9) * ticks) * unit);
        const auto steps = learner(frames, ticks * unit, most);
        REQUIRE(steps.size() == frames.size());
        double owed = 0;
        for (std::size_t k = 0; k < frames.size(); ++k) {
            owed += frames[k] / unit;
            REQUIRE(steps[k] == std::min(static_cast<int>(owed / ticks), most));
            owed = std::fmod(owed, ticks);
        }
    }
}

// All that the task allows at once: steps of picoseconds and of ages, caps of one and of millions, and frames of many
// steps below the cap and beyond. Exact to the bit, as above.
PROPERTY("a cap may be hundreds, or a million, and a replay thousands of frames long") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const double unit = std::pow(2, i % 12 == 0 ? draw.integer(-20, 40) : i * 7 % 81 - 40);
        const int ticks = draw.integer(1, 30), cap = static_cast<int>(draw.spread(1, 1000, i, 12));
        const int most = i % 12 == 0 ? 1'000'000'000 : cap, count = i == 1 ? 4000 : i < 4 ? draw.integer(40, 1000) : 8;
        std::vector<double> frames;
        for (int k = 0; k < count; ++k) {
            const int steps = k % 4 == 0 ? draw.integer(0, 2 * cap + 2) : k % 4 == 1 ? cap : draw.integer(0, cap);
            frames.push_back((steps * ticks + draw.integer(0, ticks - 1)) * unit);
        }
        if (i == 0) frames[0] = 1e6 * ticks * unit, frames[1] = draw.integer(1000, 1'000'000) * ticks * unit;
        const auto steps = learner(frames, ticks * unit, most);
        REQUIRE(steps.size() == frames.size());
        double owed = 0;
        for (std::size_t k = 0; k < frames.size(); ++k) {
            owed += frames[k] / unit;
            REQUIRE(steps[k] == std::min(static_cast<int>(owed / ticks), most));
            owed = std::fmod(owed, ticks);
        }
    }
}
