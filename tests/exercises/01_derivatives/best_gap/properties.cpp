#include "best_gap.hpp"

#include "property.hpp"

EXERCISE(best_gap);

// What a gap is to be found for. The noise is such that `ideal`, not a whole number, is the best of
// all gaps: where the slope of jerk g²/24 + 2 noise/g is zero.
struct Throw {
    double frame, jerk, noise;

    Throw(Draw& draw, double ideal) : Throw(1 / draw.real(20, 240), 24 * draw.log(0.05, 400), ideal) {}
    Throw(double frame_, double jerk_, double ideal) : frame(frame_), jerk(jerk_) {
        const double gap = ideal * frame;
        noise = jerk * gap * gap * gap / 24;
    }
    double worst(int frames) const {
        const double gap = frames * frame;
        return jerk * gap * gap / 24 + 2 * noise / gap;
    }
    int answer(int most) const { return learner(frame, noise, jerk, most); }

    /// No number of frames up to `most` is better than `frames`, but for roundoff.
    bool is_best(int frames, int most) const {
        if (frames < 1 || frames > most) return false;
        for (int other = 1; other <= most; ++other)
            if (worst(other) < worst(frames) * (1 - 1e-12)) return false;
        return true;
    }
};

PROPERTY("without noise, neighbouring frames are the best") {
    Draw draw;
    for (int i = 0; i < 20; ++i)
        REQUIRE(learner(1 / draw.real(20, 240), 0, draw.log(1, 1e4), draw.integer(1, 60)) == 1);
}

PROPERTY("without jerk, the frames may be as far apart as can be") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const int most = i % 2 == 0 ? draw.integer(1, 60) : draw.integer(61, 5000);
        REQUIRE(learner(1 / draw.real(20, 240), draw.log(1e-5, 1e-2), 0, most) == most);
    }
}

PROPERTY("no other number of frames has a smaller worst error") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        // Just below three, two mistakes differ that give half the gap: rounded 1, weighed 2.
        const Throw ball(draw, i % 10 == 0 && !draw.is_roundest() ? draw.real(2.9, 2.99) : draw.log(0.5, 30));
        const int most = draw.integer(30, 60);
        REQUIRE(ball.is_best(ball.answer(most), most));
    }
}

PROPERTY("when you keep fewer frames than you would like to, none of them is better") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Throw ball(draw, draw.real(1, 40));
        const int most = draw.integer(1, 20);
        REQUIRE(ball.is_best(ball.answer(most), most));
    }
}

// n and n + 1 are equally good where ideal³ = n (n + 1/2)(n + 1), which is a little below n + 1/2.
PROPERTY("where two numbers of frames are almost equally good, the better one is found") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        const double n = i % 2 == 0 ? draw.integer(1, 3) : draw.integer(4, 40);
        const double off = draw.sign() * draw.log(1e-9, 0.03);
        const Throw ball(draw, std::cbrt(n * (n + 0.5) * (n + 1)) * (1 + off));
        REQUIRE(ball.is_best(ball.answer(60), 60));
    }
}

// A film of an ant or of a comet. What is best depends on the jerk only beside the noise, and on
// the frame only beside the ideal gap.
PROPERTY("frames may be as short as microseconds or as long as hours, noise and jerk tiny or huge") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const double frame = draw.log(1e-6, 1e4), jerk = draw.any_of(1e-9, 1e9, {1, 12, 1e-9, 1e9});
        const int most = draw.integer(1, i % 2 == 0 ? 20 : 2000);
        const Throw ball(frame, jerk, draw.log(0.1, 2.0 * most + 1));
        REQUIRE(ball.is_best(ball.answer(most), most));
        if (i % 8 == 0) REQUIRE(learner(frame, 0, jerk, most) == 1);
        if (i % 16 == 1) REQUIRE(learner(frame, ball.noise, 0, most) == most);
    }
}

// Whoever tries every gap looks at as many as are kept.
PROPERTY("tens of thousands of frames may be kept, and the best gap may be as many") {
    Draw draw;
    for (int i = 0; i < 8; ++i) {
        const double ideal = draw.spread(4e3, 1e5, i, 8);
        const int most = static_cast<int>(ideal * draw.real(0.5, 2)) + 1;
        const Throw ball(draw.log(1e-9, 1e9), draw.log(1e-12, 1e12), ideal);
        REQUIRE(ball.is_best(ball.answer(most), most));
        if (i < 2) REQUIRE(learner(ball.frame, ball.noise, 0, most) == most);
    }
    for (int i = 0; i < 2; ++i) {
        const int most = i == 0 ? 1'000'000 : draw.integer(100'000, 1'000'000);
        const Throw ball(draw, draw.spread(1e5, 1e6, i, 2));
        REQUIRE(ball.is_best(ball.answer(most), most));
    }
}

PROPERTY("no time, no noise and no jerk is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 240; ++i) {
        const double frame = draw.spread(1e-12, 1e12, i, 15), jerk = draw.spread(1e-12, 1e12, i, 16);
        const int most = draw.integer(1, 100);
        const Throw ball(frame, jerk, draw.log(0.1, 2.0 * most + 1));
        REQUIRE(ball.is_best(ball.answer(most), most));
    }
}

// The two ends that the task names, with everything that it allows beside them.
PROPERTY(
    "without noise the best frames are neighbours, without jerk the farthest apart, for all numbers and lengths of "
    "frames") {
    Draw draw;
    Every all;
    for (int i = 0; i < 60; ++i) {
        const int most = i == 0       ? 1'000'000
                         : i % 3 == 0 ? draw.integer(1, 3)
                                      : static_cast<int>(draw.spread(1, 2e4, i, 17));
        const double frame = draw.spread(1e-12, 1e12, i, 19), other = draw.spread(1e-12, 1e12, i, 16);
        all &= learner(frame, 0, other, most) == 1;
        all &= learner(frame, other, 0, most) == most;
    }
    REQUIRE(bool(all));
}
