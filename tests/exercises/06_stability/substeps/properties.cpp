#include "substeps.hpp"

#include "property.hpp"

EXERCISE(substeps);

namespace {

struct Crate {
    double mass;
    int springs;
    double stiffness, frame, share;

    // One for which the whole frame is `steps` times as long as the longest step allowed.
    Crate(Draw& draw, double steps, double share)
        : mass(draw.log(1e-6, 1e6)),
          springs(static_cast<int>(draw.log(1, 1001))),
          frame(draw.log(1e-4, 1)),
          share(share) {
        const double omega = 2 * share * steps / frame;
        stiffness = mass * omega * omega / springs;
    }
    Crate(Draw& draw, double steps) : Crate(draw, steps, draw.log(0.01, 1)) {}

    int answer() const { return learner(mass, springs, stiffness, frame, share); }
    // omega h with so many steps in a frame.
    double wh(double steps) const { return std::sqrt(springs * stiffness / mass) * frame / steps; }
};

// A number of steps that is no whole one, by more than the roundoff of a few operations.
double draw_steps(Draw& draw, double low, double high) {
    for (;;) {
        const double steps = draw.log(low, high);
        if (std::fabs(steps - std::round(steps)) > 2e-9 * steps) return steps;
    }
}

// How far a crate gets that is let go at 1 m, in so many steps.
double farthest(const Crate& crate, double h, int steps) {
    double x = 1, v = 0, far = 1;
    for (int n = 0; n < steps && far < 1e12; ++n) {
        double force = 0;
        for (int i = 0; i < crate.springs; ++i) force -= crate.stiffness * x;
        v += h * force / crate.mass;
        x += h * v;
        far = std::max(far, std::fabs(x));
    }
    return far;
}

}  // namespace

PROPERTY("a crate without springs, or with springs that do not pull, takes one step a frame") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Crate crate(draw, draw_steps(draw, 1, 1e5));
        REQUIRE(learner(crate.mass, 0, crate.stiffness, crate.frame, crate.share) == 1);
        REQUIRE(learner(crate.mass, crate.springs, 0, crate.frame, crate.share) == 1);
    }
}

PROPERTY("with the answer omega h is at most 2 share") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const bool few = i < 40 || i % 2 == 0;  // at first, counts that can be worked out by hand
        const Crate crate(draw, draw_steps(draw, few ? 1 : 100, few ? 20 : 1e5));
        const int steps = crate.answer();
        REQUIRE(steps >= 1);
        REQUIRE(crate.wh(steps) <= 2 * crate.share * (1 + 1e-9));
    }
}

PROPERTY("with one step fewer omega h is above 2 share") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const bool few = i < 40 || i % 2 == 0;  // at first, counts that can be worked out by hand
        const Crate crate(draw, draw_steps(draw, few ? 1 : 100, few ? 20 : 1e5));
        const int steps = crate.answer();
        REQUIRE((steps == 1 || crate.wh(steps - 1) > 2 * crate.share * (1 - 1e-9)));
    }
}

// Halfway between two counts: ωh is 2.05 or more with one step fewer, and a run grows by half or
// more in each step. With the answer it is 1.95 at most, and a run stays within 1/√(1 − ω²h²/4) < 5
// of where it was let go.
PROPERTY("with all of the limit allowed a run stays bounded, and with one step fewer it explodes") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Crate crate(draw, draw.integer(1, 19) + 0.5, 1);
        const int steps = crate.answer();
        REQUIRE(steps >= 2);
        REQUIRE(farthest(crate, crate.frame / steps, 1000) < 5);
        REQUIRE(farthest(crate, crate.frame / (steps - 1), 1000) > 1e9);
    }
}

PROPERTY("it is right wherever the task allows: light and heavy crates, any count up to 100,000, just beside it") {
    Draw draw;
    bool all = true;  // every call is made, also behind a wrong one: they tell mistakes apart
    for (int i = 0; i < 400; ++i) {
        const int whole = static_cast<int>(i % 2 == 0 ? draw.log(1, 1e5) : draw.integer(1, 40));
        const double off = draw.sign() * draw.log(1.5e-9, 1e-2 / whole);
        Crate crate(draw, 1, draw.any_of(0.01, 1, {0.01, 0.5, 1}));
        crate.mass = draw.any_of(1e-6, 1e6, {1e-6, 1, 1e6});
        crate.springs = static_cast<int>(draw.any_of(1, 1000, {1, 2, 1000}));
        crate.frame = draw.any_of(1e-4, 1, {1e-4, 1.0 / 60, 1});
        const double omega = 2 * crate.share * whole * (1 + off) / crate.frame;
        crate.stiffness = crate.mass * omega * omega / crate.springs;
        all &= crate.answer() == (off > 0 ? whole + 1 : whole);
        crate.stiffness *= draw.log(1e-30, 1e-12);
        all &= crate.answer() == 1;
    }
    REQUIRE(all);
}

PROPERTY("each count of springs and of steps, each mass, frame and share that the task allows, is counted right") {
    Draw draw;
    bool all = true;
    for (int i = 0; i < 240; ++i) {
        const int whole = static_cast<int>(draw.spread(1, 99'999, i, 15));
        const double off = draw.sign() * draw.log(1.5e-9, 1e-2 / whole);
        Crate crate(draw, 1, draw.spread(0.01, 1, i, 16));
        crate.mass = draw.spread(1e-6, 1e6, i, 17);
        crate.springs = i % 7 == 0 ? 1000 : static_cast<int>(draw.spread(1, 1001, i, 13));
        crate.frame = draw.spread(1e-4, 1, i, 11);
        const double omega = 2 * crate.share * whole * (1 + off) / crate.frame;
        crate.stiffness = crate.mass * omega * omega / crate.springs;
        all &= crate.answer() == (off > 0 ? whole + 1 : whole);
    }
    REQUIRE(all);
}
