#include "camera_step.hpp"

#include "property.hpp"

EXERCISE(camera_step);

// A camera and a frame.
struct Frame {
    State<double> state;
    double target, omega, zeta, h;
};

// One camera in four has no damper.
static Frame frame(Draw& draw, double least_wh, double most_wh, double most_zeta = 1e3) {
    const double omega = draw.log(0.05, 50);
    const double zeta = draw.real(0, 1) < 0.25 ? 0 : draw.log(1e-3, most_zeta);
    return {{draw.real(0, 10), draw.real(-5, 5), draw.real(-5, 5)},
            draw.real(-5, 5),
            omega,
            zeta,
            draw.log(least_wh, most_wh) / omega};
}

static State<double> step(const Frame& f) {
    return learner(f.state, f.target, f.omega, f.zeta, f.h);
}

PROPERTY("a camera at rest on its target stays there") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Frame f = frame(draw, 0.01, 100);
        f.state = {f.state.t, f.target, 0};
        const State<double> after = step(f);
        REQUIRE(close(after.x, f.target, 0, 1e-14));
        REQUIRE(close(after.v, 0, 0, 1e-12));
    }
}

PROPERTY("the clock moves on by h") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Frame f = frame(draw, 0.01, 100);
        REQUIRE(close(step(f).t, f.state.t + f.h, 1e-14));
    }
}

// Roundoff of the positions, about 10, and of h v₁, which a way to write it may add and take away.
PROPERTY("the position moves with the new velocity") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Frame f = frame(draw, 0.01, 100);
        const State<double> after = step(f);
        REQUIRE(close(after.x, f.state.x + f.h * after.v, 0, 1e-14 * (10 + 10 * f.h)));
    }
}

// What is missing, over what stands before v₂: an error of the velocity. Roundoff of x₂, about
// ε·10, weighs ω²h/(1 + ω²h²) ≤ ω/2 there.
PROPERTY("the velocity changes by h times the acceleration at the new position and velocity") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const Frame f = frame(draw, 0.01, 100);
        const State<double> after = step(f);
        const double wh = f.omega * f.h;
        const double acceleration =
            -f.omega * f.omega * (after.x - f.target) - 2 * f.zeta * f.omega * after.v;
        const double missing = after.v - f.state.v - f.h * acceleration;
        const double error = missing / (1 + 2 * f.zeta * wh + wh * wh);
        REQUIRE(close(error, 0, 0, 1e-14 * (10 + 10 * f.omega)));
    }
}

PROPERTY("a step of zero changes nothing") {
    Draw draw;
    for (int i = 0; i < 10; ++i) {
        Frame f = frame(draw, 0.01, 100);
        f.h = 0;
        const State<double> after = step(f);
        REQUIRE(close(after.t, f.state.t, 1e-14));
        REQUIRE(close(after.x, f.state.x, 1e-14, 1e-14));
        REQUIRE(close(after.v, f.state.v, 1e-14, 1e-14));
    }
}

PROPERTY("no frame, however long, adds energy about the target") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Frame f = frame(draw, 1e-3, 1e4);
        const auto energy = [&](const State<double>& s) {
            const double swing = f.omega * (s.x - f.target);
            return s.v * s.v + swing * swing;
        };
        REQUIRE(energy(step(f)) <= energy(f.state) * (1 + 1e-12));
    }
}

// What is left of a distance d or a speed v after ωh = 1e6 is about 2ζ d/(ωh) and v/(ω · ωh).
PROPERTY("after a very long frame the camera rests on its target") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const Frame f = frame(draw, 1e6, 1e7, 2);
        const State<double> after = step(f);
        REQUIRE(close(after.x, f.target, 0, 1e-4));
        REQUIRE(close(after.v, 0, 0, 1e-3));
    }
}
