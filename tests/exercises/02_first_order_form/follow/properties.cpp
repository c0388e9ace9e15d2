#include "follow.hpp"

#include "property.hpp"

// The velocity may be written as a difference of two numbers that are 1/(ωh) times as large, of
// which 10⁻⁴ is the least that is drawn: a roundoff of a few 10⁻¹² of it.
EXERCISE_WITHIN(follow, 1e-10);

namespace {

struct Scene {
    explicit Scene(Draw& draw)
        : camera{draw.real(0, 9), draw.real(-5, 5), draw.real(-5, 5)},
          target(draw.real(-5, 5)),
          target_v(draw.sign() * draw.real(0.5, 5)),
          omega(draw.log(0.01, 1000)) {}
    State<double> after(double h) const { return learner(camera, target, target_v, omega, h); }

    State<double> camera;
    double target, target_v, omega;
};

}  // namespace

PROPERTY("a time of zero changes nothing, and after any other the clock shows it") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        Scene scene(draw);
        scene.camera.v = draw.sign() * draw.real(0.5, 5);  // at rest, this would be nothing but roundoff
        const State<double> same = scene.after(0);
        REQUIRE(same.t == scene.camera.t);
        REQUIRE(close(same.x, scene.camera.x, 0, 1e-14));
        REQUIRE(close(same.v, scene.camera.v, 0, 1e-14 * (10 + 10 * scene.omega)));
        const double h = draw.log(1e-3, 1);
        REQUIRE(close(scene.after(h).t, scene.camera.t + h, 1e-15));
    }
}

PROPERTY("a camera that rides on the player, as fast as the player, stays there") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        Scene scene(draw);
        scene.camera.x = scene.target;
        scene.camera.v = scene.target_v;
        const double h = draw.log(1e-3, 2);
        const State<double> after = scene.after(h);
        REQUIRE(close(after.x, scene.target + scene.target_v * h, 0, 1e-13));
        REQUIRE(close(after.v, scene.target_v, 0, 1e-13 * (1 + scene.omega)));
    }
}

// Both ways round by about ten units in the last place of positions up to 5 + 5 h and of velocities
// up to 5 + 10 ω.
PROPERTY("two frames land where one frame of their length does") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        const Scene scene(draw);
        const double h1 = draw.log(0.02, 3) / scene.omega, h2 = draw.log(0.02, 3) / scene.omega;
        const State<double> once = scene.after(h1 + h2);
        const double moved = scene.target + scene.target_v * h1;
        const State<double> twice = learner(scene.after(h1), moved, scene.target_v, scene.omega, h2);
        REQUIRE(close(twice.t, once.t, 1e-14));
        REQUIRE(close(twice.x, once.x, 0, 1e-13 * (10 + 10 * (h1 + h2))));
        REQUIRE(close(twice.v, once.v, 0, 1e-13 * (10 + 10 * scene.omega)));
    }
}

PROPERTY("let go at rest, the camera nears a resting player all the time and never passes") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Scene scene(draw);
        scene.target_v = scene.camera.v = 0;
        const double start = draw.sign() * draw.real(1, 5);
        scene.camera.x = scene.target + start;
        double before = 1;
        for (double phase = 0.25; phase < 8; phase += 0.25) {
            const double left = (scene.after(phase / scene.omega).x - scene.target) / start;
            REQUIRE(left > 0);
            REQUIRE(left < before);
            before = left;
        }
    }
}

// Seen from a player at rest at zero nothing hides a camera that is put on its player too soon,
// whether near to him or after so many swings. In each call the answer must be the right one.
PROPERTY(
    "near the player and far away, in short frames and long ones, the camera is where the formula "
    "says") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double omega = draw.log(1e-3, 1e3), h = draw.log(1e-4, i % 2 == 0 ? 3 : 300) / omega;
        const double size = draw.log(1e-9, 1e6), off = size * draw.any_of(-5, 5, {0, 1});
        const double v = size * omega * draw.any_of(-5, 5, {0, 1});
        const bool stands = i % 4 < 2;
        const double goal = stands ? 0 : draw.real(-5, 5), goal_v = stands ? 0 : draw.any_of(-5, 5, {0});
        // From the origin a tiny step away is less than the roundoff of where the player is.
        if (!stands && goal + off == 0) continue;
        const State<double> after = learner({0, goal + off, goal_v + v}, goal, goal_v, omega, h);
        REQUIRE(close(after.t, h, 1e-15));
    }
}

// In a tiny part of a swing a camera has hardly moved: seen from a player at rest at zero that shows, and it moves so
// fast that its velocity keeps its digits.
PROPERTY("no spring is too soft or too stiff for it, no frame too short, and no clock too late") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double omega = draw.spread(1e-9, 1e9, i, 20), h = draw.spread(1e-12, 3, i, 21) / omega;
        const double x = draw.sign() * draw.log(1e-9, 1e9), v = omega * x * draw.sign() * draw.real(0.5, 5);
        const double t = draw.sign() * draw.any_of(0, 1e6, {0});
        REQUIRE(close(learner({t, x, v}, 0, 0, omega, h).t, t + h, 1e-14));
    }
    for (int i = 0; i < 60; ++i) {
        const double omega = draw.spread(1e-9, 1e9, i, 20), h = draw.spread(1, 1e12, i, 21) / omega;
        const double goal = draw.sign() * draw.log(1e-9, 1e9), goal_v = draw.sign() * draw.log(1e-9, 1e9) / h;
        const State<double> start{0, goal * draw.real(1.1, 5), goal_v * draw.real(1.1, 5)};
        REQUIRE(close(learner(start, goal, goal_v, omega, h).t, h, 1e-14));
    }
}
