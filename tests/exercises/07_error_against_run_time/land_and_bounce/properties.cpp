#include "land_and_bounce.hpp"

#include <limits>

#include "property.hpp"

// Where bounces are slower than 1e-6 m/s the task allows any answer that is near: it is the properties that say how
// near.
EXERCISE_WITHIN(land_and_bounce, checker::many_are_right);

namespace {

// A ball in the air, rising or falling.
struct Ball {
    explicit Ball(Draw& draw)
        : s{draw.real(0, 100), draw.log(1e-3, 1e2), draw.sign() * draw.log(1e-2, 50)},
          g(draw.log(1, 25)),
          e(draw.real(0.1, 0.95)) {}

    double impact() const { return std::sqrt(s.v * s.v + 2 * g * s.x); }  // its speed
    double fall() const { return (s.v + impact()) / g; }                  // time until then
    double flight() const { return 2 * e * impact() / g; }                // from bounce to bounce
    double all_bounces() const { return flight() / (1 - e); }             // with e below 1
    double energy() const { return s.v * s.v / 2 + g * s.x; }
    State<double> after(double h) const { return learner(s, g, e, h); }

    State<double> s;
    double g, e;
};

// How far off a learner may be at rest, and where bounces are slower than that.
constexpr double still = 1e-6;

bool is_at(const State<double>& s, double t, double x, double v, double size_x, double size_v, double absolute) {
    return close(s.t, t, 1e-12) && close(s.x, x, 0, 1e-10 * size_x + absolute) &&
           close(s.v, v, 0, 1e-10 * size_v + absolute);
}

// Sizes are those of the flight: its top and its landing.
bool is_at(const Ball& ball, const State<double>& s, double t, double x, double v, double absolute = 0) {
    return is_at(s, t, x, v, ball.energy() / ball.g, ball.impact(), absolute);
}

// What comes next cannot begin below the ground, not even by a rounding.
State<double> on_or_above(State<double> s) {
    s.x = std::max(0.0, s.x);
    return s;
}

}  // namespace

PROPERTY("a ball that does not come down within the step flies as if there were no ground") {
    Draw draw;
    for (int i = 0; i < 80; ++i) {
        Ball ball(draw);
        if (i % 4 == 0) ball.s = {ball.s.t, 0, std::fabs(ball.s.v)};  // from the ground
        if (i % 4 == 1) ball.e = i % 8 == 1 ? 0 : 1;
        const double h = ball.fall() * draw.real(0.01, 0.99);
        const double x = ball.s.x + ball.s.v * h - ball.g * h * h / 2, v = ball.s.v - ball.g * h;
        REQUIRE(is_at(ball, ball.after(h), ball.s.t + h, x, v));
    }
}

PROPERTY("a ball that lies on the ground stays there, whatever the step") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const double t = draw.real(0, 100), g = draw.log(1, 25), h = draw.log(1e-4, 1e3);
        const double e = i % 3 == 0 ? 0 : i % 3 == 1 ? 1 : draw.real(0.1, 0.95);
        REQUIRE(is_at(learner({t, 0, 0}, g, e, h), t + h, 0, 0, 0, 0, still));
    }
}

PROPERTY("after one bounce a ball that was dropped comes back to e^2 of its height") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        Ball ball(draw);
        ball.s.v = 0;
        if (i % 5 == 0) ball.e = 1;
        const double h = ball.fall() + ball.flight() / 2;
        REQUIRE(is_at(ball, ball.after(h), ball.s.t + h, ball.e * ball.e * ball.s.x, 0));
    }
}

PROPERTY("a ball on the ground that moves down bounces at once, as if it were on its way up") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        Ball ball(draw);
        if (i % 3 == 0) ball.e = 1;
        const double v = std::fabs(ball.s.v), t = ball.s.t;
        const double h = 0.97 * 2 * v / ball.g * draw.log(0.01, i % 3 == 0 ? 10 : 2);  // not at a bounce
        const State<double> up = learner({t, 0, ball.e * v}, ball.g, ball.e, h);
        const State<double> down = learner({t, 0, -v}, ball.g, ball.e, h);
        REQUIRE(is_at(down, up.t, up.x, up.v, v * v / ball.g, v, still));
    }
}

PROPERTY("when the time of all its bounces is over, the ball lies still") {
    Draw draw;
    for (int i = 0; i < 60; ++i) {
        Ball ball(draw);
        if (i % 5 == 0) ball.e = 0;
        const double h = ball.fall() + ball.all_bounces() * draw.real(1.01, 3) + draw.log(1e-3, 10);
        REQUIRE(is_at(ball.after(h), ball.s.t + h, 0, 0, 0, 0, still));
    }
}

PROPERTY("one step is as good as two, wherever it is cut, with many bounces or none") {
    Draw draw;
    for (int i = 0; i < 150; ++i) {
        Ball ball(draw);
        double bounces = ball.all_bounces();
        if (i % 5 == 0) ball.e = 1, bounces = 20 * ball.flight();
        if (i % 5 == 1) ball.e = 0, bounces = 0;
        const double h = 0.97 * (ball.fall() + bounces) * draw.log(0.01, 1.2), cut = draw.real(0, 1) * h;
        const State<double> one = ball.after(h), half = on_or_above(ball.after(cut));
        const State<double> two = learner(half, ball.g, ball.e, h - cut);
        REQUIRE(is_at(ball, two, one.t, one.x, one.v, still));
    }
}

// The flight after `bounces` of them, `share` of it gone by. Times are known to some roundoffs of all that they are
// made of, and so are places and velocities.
PROPERTY("it is right wherever the task allows: from the ground or 2000 m up, slow or fast, any restitution and step") {
    Draw draw;
    Every all;
    for (int i = 0; i < 500; ++i) {
        Ball ball(draw);
        ball.s.x = draw.any_of(0, 2000, {0, 1e-6, 1, 2000}), ball.s.v = draw.any_of(-100, 100, {-100, 0, 100});
        ball.g = draw.any_of(1, 25, {1, 9.81, 25}), ball.e = draw.any_of(0, 0.95, {0, 0.5, 0.95, 1});
        const double impact = ball.impact(), g = ball.g, e = ball.e, share = draw.real(0.02, 0.98);
        const int most = i % 4 == 0 ? 0 : i % 4 == 1 ? 3 : e == 1 ? 1000 : 400;
        double speed = impact, h = ball.fall(), flight = 0;
        const bool as_many_as_can_be = most == 1000 && i % 4 == 3;
        const int bounces = as_many_as_can_be ? most : draw.integer(most > 3 ? 4 : 0, most);
        for (int n = 0; n < bounces && h < 9e4; ++n) {
            h += flight, speed *= e, flight = 2 * speed / g;
            if (speed < 2e-6) break;
        }
        const double off = 1e-13 * (h + flight + impact / g + (e < 1 ? ball.all_bounces() : 0));
        if (e == 1 && impact < 1e-5) continue;  // it would bounce without end, where nobody sees it
        if (bounces == 0) {
            h *= share;
            if (h < 100 * off || ball.fall() - h < 100 * off) continue;
            const double x = ball.s.x + ball.s.v * h - g * h * h / 2;
            const State<double> s = ball.after(h);
            const double slow = impact < 1e-5 ? still : 0;
            all &= close(s.x, x, 0, impact * off + slow) && close(s.v, ball.s.v - g * h, 0, g * off + slow);
        } else if (speed < 2e-6) {
            const double longer = std::min(h + 2 * flight / (1 - e) + draw.log(1e-3, 1e5), 1e5);
            all &= is_at(ball.after(longer), ball.s.t + longer, 0, 0, 0, 0, still);
        } else {
            const double since = share * flight;
            if (std::min(since, flight - since) < 100 * off || h + since > 1e5) continue;
            const State<double> s = ball.after(h + since);
            const double x = since * (speed - g * since / 2);
            all &= close(s.t, ball.s.t + h + since, 1e-12);
            all &= close(s.x, x, 0, 10 * speed * off) && close(s.v, speed - g * since, 0, 10 * g * off + 1e-12 * speed);
        }
    }
    REQUIRE(bool(all));
}

// Whoever puts the ball to rest below some speed has to choose one that nobody sees.
PROPERTY("bounces of a few thousandths or millionths of a metre per second are bounces, too") {
    Draw draw;
    Every all;
    for (int i = 0; i < 200; ++i) {
        Ball ball(draw);
        const int bounces = i % 3;
        const double speed = draw.spread(1.1e-6, 1, i, 40), v = speed / std::pow(ball.e, bounces);
        ball.s = {ball.s.t, 0, v};
        double h = 0, up = v;
        for (int n = 0; n < bounces; ++n) h += 2 * up / ball.g, up *= ball.e;
        const double since = draw.real(0.05, 0.95) * 2 * up / ball.g;
        const double right = up - ball.g * since;
        all &= close(ball.after(h + since).v, right, 0, 1e-9 * v);
    }
    REQUIRE(bool(all));
}

// A short step from any place: the ball flies, or bounces once.
PROPERTY("no step is too short for it, at any time of the clock") {
    Draw draw;
    Every all;
    for (int i = 0; i < 240; ++i) {
        Ball ball(draw);
        const double h = draw.spread(1e-12, 1e-2, i, 20), share = draw.real(0.1, 0.9), g = ball.g;
        ball.s.t = draw.sign() * draw.any_of(0, 1e6, {0});
        ball.e = i % 3 == 0 ? 1 : draw.real(0.5, 0.95);
        if (i % 2 == 0) {
            const double x = ball.s.x + ball.s.v * h - g * h * h / 2, v = ball.s.v - g * h;
            if (ball.fall() > 2 * h) all &= is_at(ball, ball.after(h), ball.s.t + h, x, v);
            continue;
        }
        const double down = draw.real(10, 100);  // so fast that it does not come down again in h
        ball.s.x = share * h * down, ball.s.v = -down;
        const double impact = ball.impact(), fall = 2 * ball.s.x / (impact + down);
        const double since = h - fall, up = ball.e * impact, right = up * since - g * since * since / 2;
        const double off = 1e-14 * impact / g;  // roundoff of a fall that is found as a difference of speeds
        const State<double> s = ball.after(h);
        if (since < 0.01 * h + off || fall < off) continue;
        all &= close(s.t, ball.s.t + h, 1e-12);
        all &= close(s.x, right, 1e-9, up * off) && close(s.v, up - g * since, 1e-9);
    }
    REQUIRE(bool(all));
}
