#include "bounce_without_velocity.hpp"

#include "property.hpp"

EXERCISE(bounce_without_velocity);

// A ball that has sunk through the floor in the last step, the floor at any height. Some balls lay
// on the floor before, and some are only just below it.
struct Sunk {
    explicit Sunk(Draw& draw)
        : floor(draw.sign() * draw.real(1, 5)),
          before(floor + std::max(0.0, draw.real(-1, 3))),
          now(floor - draw.log(1e-9, 3)) {}

    double floor, before, now;
};

PROPERTY("a ball that is not below the floor is left alone, rising or falling") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double floor = draw.sign() * draw.real(1, 5);
        const double before = floor + draw.real(0, 3), e = draw.real(0, 0.9);
        const double now = i % 10 == 9 ? floor : floor + draw.log(1e-9, 3);
        REQUIRE(learner(before, now, floor, e) == std::array{before, now});
    }
}

// Roundoff here and below: a few terms of at most 10 metres.
PROPERTY("it leaves the floor with the given part of the speed, upwards") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Sunk ball(draw);
        const double e = draw.real(0.1, 0.9);
        const auto [before, now] = learner(ball.before, ball.now, ball.floor, e);
        REQUIRE(close(now - before, -e * (ball.now - ball.before), 0, 1e-13));
    }
}

PROPERTY("a ball that does not bounce lies on the floor, and stays there") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Sunk ball(draw);
        const auto [before, now] = learner(ball.before, ball.now, ball.floor, 0);
        REQUIRE(close(now, ball.floor, 1e-15));
        REQUIRE(close(before, ball.floor, 1e-15));
    }
}

PROPERTY("a ball that lay on the floor and has sunk bounces as well, and be it by a hair") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        Sunk ball(draw);
        ball.before = ball.floor;
        const double e = draw.real(0.1, 0.9), depth = ball.floor - ball.now;
        const auto [before, now] = learner(ball.before, ball.now, ball.floor, e);
        REQUIRE(close(before, ball.floor, 0, 1e-13));
        REQUIRE(close(now, ball.floor + e * depth, 0, 1e-13));
    }
}

PROPERTY("it rises for as much of the step as is left when it hits the floor") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const Sunk ball(draw);
        const double e = draw.real(0.1, 0.9), speed = ball.before - ball.now;
        const double left = 1 - (ball.before - ball.floor) / speed;
        const auto [before, now] = learner(ball.before, ball.now, ball.floor, e);
        REQUIRE(close(now, ball.floor + e * speed * left, 0, 1e-13));
    }
}

// Above a floor at zero neither height is far less than the way: the film of the bounce keeps its digits.
PROPERTY("it is right wherever the task allows: at rest, by a hair's breadth, with any restitution") {
    Draw draw;
    for (int i = 0; i < 400; ++i) {
        const double size = draw.log(1e-9, 1e6), least = i % 2 == 0 ? 1e-2 : 1e-9;
        const double floor = i % 2 == 0 ? 0 : size * draw.sign() * draw.real(1, 50);
        const double above = draw.integer(0, 3) == 0 ? 0 : size * draw.log(least, 1);
        const double way = size * draw.log(least, 10);
        const double now = i % 8 > 1 ? floor - way : i % 16 > 1 ? floor + way : floor;
        const double e = draw.any_of(0, 1, {0, 1, 1e-3, 0.999});
        REQUIRE(std::isfinite(learner(floor + above, now, floor, e)[1]));
    }
}

PROPERTY("no floor, no fall and no restitution is too small or too large for it") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double size = draw.spread(1e-12, 1e12, i, 20), e = draw.spread(1e-12, 1, i, 19);
        const double floor = i % 2 == 0 ? 0 : size * draw.sign() * draw.log(1e-3, 1e3);
        const double above = i % 5 == 0 ? 0 : size * draw.log(1e-2, 10), way = size * draw.log(1e-2, 10);
        REQUIRE(std::isfinite(learner(floor + above, floor + (i % 4 == 3 ? way : -way), floor, e)[1]));
    }
}
