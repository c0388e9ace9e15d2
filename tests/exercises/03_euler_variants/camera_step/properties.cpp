#include "camera_step.hpp"

#include "property.hpp"

EXERCISE_WITHIN(camera_step, 1e-10);

// A camera and a frame.
struct Frame {
    State<double> state;
    double target, omega, zeta, h;
};

// One camera in four has no damper. No target is at zero: after a long frame, a position there
// would be nothing but the roundoff of the old one.
static Frame frame(Draw& draw, double least_wh, double most_wh, double most_zeta = 1e3) {
    const double omega = draw.log(0.05, 50);
    const double zeta = draw.real(0, 1) < 0.25 ? 0 : draw.log(1e-3, most_zeta);
    return {{draw.real(0, 10), draw.real(-5, 5), draw.real(-5, 5)},
            draw.sign() * draw.real(1, 5),
            omega,
            zeta,
            draw.log(least_wh, most_wh) / omega};
}

static State<double> step(const Frame& f) { return learner(f.state, f.target, f.omega, f.zeta, f.h); }

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
// ε·10, weighs ω²h/(1 + ω²h²) ≤ ω/2 there; over h, which is 0.01/ω or more, it is ω 10⁻¹³.
PROPERTY("the velocity changes by h times the acceleration at the new position and velocity") {
    Draw draw;
    for (int i = 0; i < 200; ++i) {
        const Frame f = frame(draw, 0.01, 100);
        const State<double> after = step(f);
        const double wh = f.omega * f.h;
        const double acceleration = -f.omega * f.omega * (after.x - f.target) - 2 * f.zeta * f.omega * after.v;
        const double missing = after.v - f.state.v - f.h * acceleration;
        const double error = missing / (1 + 2 * f.zeta * wh + wh * wh);
        REQUIRE(close(error, 0, 0, 1e-12 * (1 + f.omega)));
    }
}

PROPERTY("no frame, however long, adds energy about the target") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        Frame f = frame(draw, 1e-3, 1e4);
        if (f.omega * f.h > 100) f.state.v /= f.h;
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
        Frame f = frame(draw, 1e6, 1e7, 2);
        f.state.v /= f.h;  // some metres in all of the frame
        const State<double> after = step(f);
        REQUIRE(close(after.x, f.target, 0, 1e-4));
        REQUIRE(close(after.v, 0, 0, 1e-3));
    }
}

// Seen from a target at zero nothing hides a camera that is put there too soon; after a long frame,
// see above. In each call the answer must be the right one.
PROPERTY("near its target and far away, in short frames and long ones, the camera moves by the rule") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double omega = draw.log(1e-3, 1e3), wh = i % 8 == 0 ? 0 : draw.log(1.001e-6, i % 2 == 0 ? 3 : 1e4);
        const double size = draw.log(1e-9, 1e6), h = wh / omega, zeta = draw.any_of(0, 20, {0, 1, 1});
        const double x = size * draw.sign() * draw.log(1e-3, 5);
        const double v = x * std::min(omega, 10 / h) * draw.any_of(-2, 2, {0, 1});
        const double target = wh > 30 || i % 4 == 0 ? size * draw.sign() * draw.real(1, 5) : 0;
        // From the origin a tiny step away is less than the roundoff of where the target is.
        if (target != 0 && target + x == 0) continue;
        REQUIRE(close(learner({0, target + x, v}, target, omega, zeta, h).t, h, 1e-15));
    }
}

// A hard damper leaves little of the old velocity, up to a ten thousandth: see above.
PROPERTY("no damper is too hard for it and no spring too soft or too stiff, in frames from tiny ones to ages") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double omega = draw.spread(1e-9, 1e9, i, 19), t = draw.sign() * draw.any_of(0, 1e6, {0});
        const double zeta = draw.spread(1e-12, 1e9, i, 20), damped = draw.spread(1e-9, 1e4, i, 21);
        const double h = std::clamp(zeta > 1 ? damped / zeta : damped, 1.001e-6, 30.0) / omega;
        const double x = draw.sign() * draw.log(1e-9, 1e9), v = omega * x * draw.real(-2, 2);
        REQUIRE(close(learner({t, x, v}, 0, omega, zeta, h).t, t + h, 1e-14));
    }
    // After a very long frame it is near its target, and that at a velocity that is told by the way.
    for (int i = 0; i < 60; ++i) {
        const double omega = draw.spread(1e-9, 1e9, i, 19), wh = draw.spread(30, 1e9, i, 20);
        const double target = draw.sign() * draw.log(1e-9, 1e9), h = wh / omega, zeta = draw.any_of(0, 20, {0, 1});
        const double away = target * draw.real(0.1, 5), v = draw.any_of(-5, 5, {0}) * away / h;
        REQUIRE(close(learner({0, target + away, v}, target, omega, zeta, h).t, h, 1e-14));
    }
}
