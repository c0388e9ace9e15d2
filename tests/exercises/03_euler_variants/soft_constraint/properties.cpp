#include "soft_constraint.hpp"

#include "property.hpp"

// As the task says.
static constexpr double near_enough = 1e-9;
EXERCISE_WITHIN(soft_constraint, near_enough);

struct Soft {
    double mass, omega, zeta, h;

    std::array<double, 2> answer() const { return learner(mass, omega, zeta, h); }
};

static Soft draw_soft(Draw& draw) {
    const double omega = draw.log(0.5, 200);
    return {draw.log(0.1, 1000), omega, draw.log(1e-3, 100), draw.log(1.001e-3, std::min(omega, 100.0)) / omega};
}

PROPERTY("beta lies between zero and one, and gamma is above zero") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const auto [gamma, beta] = draw_soft(draw).answer();
        REQUIRE(gamma > 0);
        REQUIRE(beta > 0);
        REQUIRE(beta < 1);
    }
}

// v₁ and C are of the size of 1 to each other: C is drawn in units of h. What is missing, over what
// stands before v₂, is an error of the velocity.
PROPERTY("the solver's velocity is that of implicit Euler, whatever the error and the velocity") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Soft s = draw_soft(draw);
        const auto [gamma, beta] = s.answer();
        for (int j = 0; j < 5; ++j) {
            const double v1 = draw.real(-1, 1), C = draw.real(-1, 1) * s.h;
            const double impulse = -(v1 + beta / s.h * C) / (1 / s.mass + gamma);
            const double v2 = v1 + impulse / s.mass, x2 = C + s.h * v2;
            const double acceleration = -s.omega * s.omega * x2 - 2 * s.zeta * s.omega * v2;
            const double wh = s.omega * s.h;
            const double missing = v2 - v1 - s.h * acceleration;
            REQUIRE(close(missing / (1 + 2 * s.zeta * wh + wh * wh), 0, 0, near_enough));
        }
    }
}

PROPERTY("without a damper the whole error is to be taken back, whatever the spring") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Soft s = draw_soft(draw);
        s.zeta = 0;
        const auto [gamma, beta] = s.answer();
        REQUIRE(close(beta, 1, near_enough));
        // So a step that starts on the spot with v₁ ends with v₁/(1 + ω²h²): mass γ = 1/(ωh)².
        REQUIRE(close(s.mass * gamma * s.omega * s.h * s.omega * s.h, 1, near_enough));
    }
}

PROPERTY("springs of the same omega h and zeta have the same gamma and beta") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        Soft s = draw_soft(draw);
        const auto one = s.answer();
        const double slower = draw.log(0.1, std::min(10.0, 1 / s.h));  // no step is longer than a second
        s.omega /= slower;
        s.h *= slower;
        const auto other = s.answer();
        REQUIRE(close(one[0], other[0], 2 * near_enough));
        REQUIRE(close(one[1], other[1], 2 * near_enough));
    }
}

// A feather and a train. In each call both numbers must be the right ones.
PROPERTY(
    "light bodies and heavy ones, soft springs and stiff, short steps and long, have their gamma "
    "and beta") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double mass = draw.log(1e-6, 1e6), omega = draw.log(2e-3, 1e6);
        const double zeta = draw.any_of(0, 100, {0, 1, 0.7});
        const auto [gamma, beta] = learner(mass, omega, zeta, draw.log(1.001e-3, std::min(omega, 99.0)) / omega);
        REQUIRE(gamma > 0);
        REQUIRE(beta <= 1 + near_enough);
    }
}

PROPERTY("no mass, no spring and no damper is too small or too large for it, and no step") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double mass = draw.spread(1e-12, 1e12, i, 17), omega = draw.spread(2e-3, 1e6, i, 19);
        const double zeta = i % 20 == 0 ? 0 : draw.spread(1e-12, 100, i, 20);
        const double wh = draw.spread(1.001e-3, std::min(omega, 99.0), i, 21);
        const auto [gamma, beta] = learner(mass, omega, zeta, wh / omega);
        REQUIRE(gamma > 0);
        REQUIRE(beta <= 1 + near_enough);
    }
}
