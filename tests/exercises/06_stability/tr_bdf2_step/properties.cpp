#include "tr_bdf2_step.hpp"

#include "property.hpp"
#include "last_comparison.hpp"

// Far out R is some 5/z, and whoever adds up rates, which are |z| times as large as the velocity, loses |z|
// roundoffs: how many digits must be right, the properties say.
EXERCISE_WITHIN(tr_bdf2_step, checker::many_are_right);

namespace {

using Complex = std::complex<double>;

// What both parts make of a decay that begins at one.
Complex R(Complex z) {
    const double gamma = 2 - std::sqrt(2.0);
    const Complex between = (1.0 + gamma / 2 * z) / (1.0 - gamma / 2 * z);
    // The slope of the parabola at its end, h f(y2) = z y2, has these weights of its three points.
    const double old = (1 - gamma) / gamma, middle = -1 / (gamma * (1 - gamma));
    const double end = (2 - gamma) / (1 - gamma);
    return -(old + middle * between) / (end - z);
}

struct Turret {
    double omega, zeta;

    std::array<Complex, 2> rates() const {
        const Complex fast = -omega * (zeta + std::sqrt(Complex(zeta * zeta - 1)));
        return {fast, omega * omega / fast};
    }
    // The true motion: v minus one rate times x decays with the other.
    State<double> exact(const State<double>& s, double time) const {
        const auto [a, b] = rates();
        const Complex u = (s.v - b * s.x) * std::exp(a * time);
        const Complex w = (s.v - a * s.x) * std::exp(b * time);
        return {s.t + time, ((u - w) / (a - b)).real(), ((a * u - b * w) / (a - b)).real()};
    }
    double energy(const State<double>& s) const { return (s.v * s.v + omega * omega * s.x * s.x) / 2; }
    State<double> draw_state(Draw& draw) const {
        const double x = draw.sign() * draw.real(0.2, 1), u = draw.sign() * draw.real(0.2, 1);
        return {draw.real(0, 1), x, omega * u};
    }
    // Is each decay multiplied as it should? Position and velocity are found from terms up to |z|
    // times as large, and whoever adds up rates, which are |z| times as large again, loses that.
    bool step_is_right(Draw& draw, double h) const {
        const State<double> s = draw_state(draw), next = learner(s, omega, zeta, h);
        const auto [a, b] = rates();
        const double largest = std::max(std::abs(a), std::abs(b));
        const double scale = std::fabs(s.v) + largest * std::fabs(s.x);
        const double tolerance = 1e-14 * (1 + h * largest) * (1 + h * largest) * scale;
        const auto right = [&](Complex rate, Complex other) {
            const Complex before = s.v - other * s.x, after = next.v - other * next.x, wanted = R(h * rate) * before;
            using checker::in_words;
            return checker::agree(std::abs(after - wanted) <= tolerance,
                                  "One decay has the rate a = " + in_words(rate) +
                                      ", the other b = " + in_words(other) + ". With z = " + in_words(h * rate) +
                                      ", R(z) = " + in_words(R(h * rate)) + " multiplies v - b x, which was " +
                                      in_words(before) + ". After the step it is",
                                  after, wanted);
        };
        return right(a, b) && right(b, a);
    }
};

double draw_omega(Draw& draw) { return draw.log(1e-3, 1e6); }

}  // namespace

PROPERTY("a step goes on in time by h, and a step of zero changes nothing") {
    Draw draw;
    for (int i = 0; i < 30; ++i) {
        const Turret turret{draw_omega(draw), draw.log(1e-3, 1e3)};
        const State<double> s = turret.draw_state(draw);
        const double h = draw.log(1e-3, 1) / (turret.omega * (1 + turret.zeta));
        REQUIRE(close(learner(s, turret.omega, turret.zeta, h).t, s.t + h, 1e-14));
        const State<double> same = learner(s, turret.omega, turret.zeta, 0);
        REQUIRE((same.t == s.t && close(same.x, s.x, 1e-14) && close(same.v, s.v, 1e-14)));
    }
}

PROPERTY("each decay of the spring is multiplied by this method's R(z), damped or not") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Turret swing{draw_omega(draw), 0};
        REQUIRE(swing.step_is_right(draw, draw.log(1e-6, 1e2) / swing.omega));
        const Turret damped{draw_omega(draw), draw.log(1e-3, 1)};
        REQUIRE(damped.step_is_right(draw, draw.log(1e-6, 1e2) / damped.omega));
    }
}

// Several runs together: for one alone the first term of the error may happen to be small.
PROPERTY("a run ends where the true motion ends, and the order of its error is two") {
    Draw draw;
    double coarse = 0, fine = 0;
    for (int run = 0; run < 6; ++run) {
        const Turret turret{draw.log(0.1, 10), draw.real(0.05, 0.8)};
        const State<double> start = turret.draw_state(draw);
        const double end = 2 / turret.omega;
        const State<double> right = turret.exact(start, end);
        const auto error = [&](int steps) {
            State<double> s = start;
            for (int n = 0; n < steps; ++n) s = learner(s, turret.omega, turret.zeta, end / steps);
            return std::hypot(s.x - right.x, (s.v - right.v) / turret.omega);
        };
        coarse += error(60);
        fine += error(120);
    }
    REQUIRE(fine < 1e-2);
    REQUIRE(close(order(coarse, fine), 2, 0, 0.1));
}

PROPERTY("no step adds energy, however long it is, with a damper or without") {
    Draw draw;
    for (int i = 0; i < 100; ++i) {
        const Turret turret{draw_omega(draw), i % 2 == 0 ? 0 : draw.log(1e-3, 10)};
        const State<double> s = turret.draw_state(draw);
        const double h = draw.log(1e-3, 1e5) / turret.omega;
        const State<double> next = learner(s, turret.omega, turret.zeta, h);
        REQUIRE(checker::below("(v² + omega² x²)/2 is", turret.energy(next), turret.energy(s) * (1 + 1e-13) + 1e-300));
    }
}

// Far out R is 5/z or so.
PROPERTY("a stiff spring is at rest after one step; one twice as fast has half as much left") {
    Draw draw;
    for (int i = 0; i < 40; ++i) {
        const Turret turret{draw_omega(draw), i % 2 == 0 ? 0 : draw.real(0, 2)};
        const State<double> s = turret.draw_state(draw);
        const double h = draw.spread(1e4, 5e5, i / 2, 20) / turret.omega;
        const double before = turret.energy(s);
        const double left = turret.energy(learner(s, turret.omega, turret.zeta, h)) / before;
        REQUIRE(checker::below("Of the energy this share is left:", left, 1e-5));
        const double longer = turret.energy(learner(s, turret.omega, turret.zeta, 2 * h)) / before;
        REQUIRE((turret.zeta > 0 || (left > 0 && close(longer, left / 4, 1e-3))));
    }
}

PROPERTY("it is right wherever the task allows: at rest, soft, stiff or critical, in tiny steps and in huge ones") {
    Draw draw;
    Every all;
    for (int i = 0; i < 400; ++i) {
        const double near = 1 + draw.sign() * draw.log(1e-10, 1e-1);
        const double zeta = i % 4 == 0 ? near : i % 4 == 1 ? draw.log(1e-9, 1e9) : draw.any_of(0, 2, {0, 1});
        const Turret turret{draw.any_of(1e-3, 1e6, {1e-3, 1, 1e6}), zeta};
        const double fastest = turret.omega * std::max(1.0, zeta);
        all &= turret.step_is_right(draw, draw.any_of(0, 1e6, {0, 1e-6, 0.5, 1e3, 1e6}) / fastest);
        const State<double> begin{draw.real(-9, 9), i % 3 == 0 ? 0 : draw.sign() * draw.log(1e-6, 1e6),
                                  i % 3 == 1 ? 0 : draw.sign() * draw.log(1e-6, 1e6)};
        const double omega = i % 8 == 7 ? 0 : turret.omega, h = draw.log(1e-9, 10) / fastest;
        all &= close(learner(begin, omega, zeta, h).t, begin.t + h, 1e-13, 1e-13);
    }
    REQUIRE(bool(all));
}

// Far out the right step is a difference of numbers that are |z| times as large, for those who add up rates: a roundoff
// of ε|z|. R is 5/z or so, ten thousand times that.
PROPERTY("in the longest steps of all each decay is multiplied by R(z), too: it is small, but not zero") {
    Draw draw;
    Every all;
    for (int i = 0; i < 240; ++i) {
        const Turret turret{draw_omega(draw), i % 2 == 0 ? 0 : draw.spread(1e-6, 0.9, i, 15)};
        const double wh = i % 16 == 0 ? 0.999999e6 : draw.spread(1e3, 1e6, i, 16), h = wh / turret.omega;
        const State<double> s = turret.draw_state(draw), next = learner(s, turret.omega, turret.zeta, h);
        const auto [a, b] = turret.rates();
        const auto left = [&](Complex rate, Complex other) {
            const Complex before = s.v - other * s.x, after = next.v - other * next.x;
            return std::abs(after - R(h * rate) * before) / (turret.omega * (1 + std::fabs(s.x)));
        };
        all &= std::max(left(a, b), left(b, a)) <= 1e-14 * wh;
    }
    REQUIRE(bool(all));
}
