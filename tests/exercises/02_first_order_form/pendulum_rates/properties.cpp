#include "pendulum_rates.hpp"

#include "property.hpp"

EXERCISE(pendulum_rates);

// A sine may be written as a cosine, with a quarter turn of nine digits.
static constexpr double quarter_turn = 4e-9;

// Every other lamp has gone over the top, up to fifty times. An answer may take whole turns off,
// with a roundoff of 300 radians.
static double angle_of(Draw& draw) { return draw.real(0, 1) < 0.5 ? draw.real(-4, 4) : draw.real(-300, 300); }

PROPERTY("a lamp at rest stays where it is, straight below the hook and straight above") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double g = draw.real(1, 25), length = draw.log(0.2, 5), drag = draw.log(0.01, 1);
        for (const double angle : {0.0, std::numbers::pi, -std::numbers::pi}) {
            const auto rates = learner({draw.real(0, 9), angle, 0}, g, length, drag);
            REQUIRE(rates[0] == 0);
            REQUIRE(close(rates[1], 0, 0, quarter_turn * g / length));
        }
    }
}

PROPERTY("the rate of change of the angle is the angular velocity, whatever the forces are") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const State<double> s{draw.real(0, 9), angle_of(draw), draw.real(-5, 5)};
        const auto rates = learner(s, draw.real(1, 25), draw.log(0.2, 5), draw.log(0.01, 1));
        REQUIRE(close(rates[0], s.v, 1e-15));
    }
}

PROPERTY("let go at rest, the lamp is pulled along the arc by gravity's share across the cable") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double g = draw.real(1, 25), length = draw.log(0.2, 5), angle = angle_of(draw);
        const auto rates = learner({draw.real(0, 9), angle, 0}, g, length, draw.log(0.01, 1));
        REQUIRE(rates[0] == 0);
        REQUIRE(close(length * rates[1], -g * std::sin(angle), quarter_turn, quarter_turn * g));
    }
}

// Energy per mass, (length v)²/2 + g length (1 − cos x), by the rates of x and v.
PROPERTY("without air the energy does not change at any moment of the oscillation") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const State<double> s{draw.real(0, 9), angle_of(draw), draw.real(-5, 5)};
        const double g = draw.real(1, 25), length = draw.log(0.2, 5);
        const auto rates = learner(s, g, length, 0);
        const double moving = length * length * s.v * rates[1];
        const double rising = g * length * std::sin(s.x) * rates[0];
        REQUIRE(close(moving + rising, 0, 0, quarter_turn * g * length * std::fabs(s.v)));
    }
}

PROPERTY("the air takes energy both ways, drag times the cube of the speed each second") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const State<double> s{draw.real(0, 9), angle_of(draw), draw.sign() * draw.log(0.1, 8)};
        const double g = draw.real(1, 25), length = draw.log(0.2, 5), drag = draw.log(0.01, 1);
        const auto rates = learner(s, g, length, drag);
        const double moving = length * length * s.v * rates[1];
        const double rising = g * length * std::sin(s.x) * rates[0];
        const double lost = drag * std::pow(std::fabs(length * s.v), 3);
        REQUIRE(close(moving + rising, -lost, quarter_turn, quarter_turn * g * length * std::fabs(s.v)));
    }
}

// At the ends of a turn, and so near to hanging still that only gravity or only the air is left. In
// each call both rates must be the right ones.
PROPERTY(
    "small swings and wild ones have their rates: any angle, any speed, any cable, thick air or "
    "none") {
    Draw draw;
    const double turn = 2 * std::numbers::pi;
    for (int i = 0; i < 400; ++i) {
        const double angle = draw.any_of(-10, 10, {0, turn / 4, -turn / 4, turn / 2, turn, -5 * turn});
        const double v = draw.any_of(-100, 100, {0, 1, -1});
        const double g = draw.log(1e-3, 1e3), length = draw.log(1e-3, 1e3);
        const double drag = draw.any_of(0, 10, {0, 0.1});
        REQUIRE(close(learner({0, angle, v}, g, length, drag)[0], v, 1e-15));
    }
}

PROPERTY(
    "no angle and no speed is too large for it, no cable too short or too long, and no air too thin or too thick") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double v = draw.sign() * draw.spread(1e-12, 1e9, i, 20), length = draw.spread(1e-9, 1e9, i, 21);
        const double g = draw.spread(1e-9, 1e9, i, 19), angle = draw.sign() * draw.spread(1e-12, 1e6, i, 17);
        // So much that the air brakes about as much as gravity pulls, or any.
        const double drag = i % 2 == 0 ? g / (length * v * length * v) * draw.log(0.1, 10) : draw.log(1e-12, 1e12);
        const State<double> s{draw.any_of(-1e6, 1e6, {0}), angle, v};
        REQUIRE(close(learner(s, g, length, drag)[0], v, 1e-15));
    }
}
