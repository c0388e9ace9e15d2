#include "fourth_order_leapfrog.hpp"

#include "property.hpp"

EXERCISE_WITHIN(fourth_order_leapfrog, checker::many_are_right);

// A wide swing at any moment of it, angles and rates of change alike.
static State<double> swinging(Draw& draw, double omega) {
    const double x = draw.sign() * draw.real(0.5, 2), v = omega * draw.sign() * draw.real(0.2, 1);
    return {draw.real(0, 10), x, v};
}

// The pendulum by classical Runge-Kutta in so many steps that its error is roundoff.
static State<double> exact(State<double> s, double omega, double time, int steps = 2000) {
    const double h = time / steps;
    const auto a = [&](double x) { return -omega * omega * std::sin(x); };
    for (int n = 0; n < steps; ++n) {
        const double v1 = s.v, a1 = a(s.x);
        const double v2 = s.v + h / 2 * a1, a2 = a(s.x + h / 2 * v1);
        const double v3 = s.v + h / 2 * a2, a3 = a(s.x + h / 2 * v2);
        const double v4 = s.v + h * a3, a4 = a(s.x + h * v3);
        s.x += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
        s.v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
    return {s.t + time, s.x, s.v};
}

PROPERTY("a step goes on in time by h, and a step of zero changes nothing") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double omega = draw.real(1, 3), h = draw.sign() * draw.real(0.1, 0.3);
        const State<double> s = swinging(draw, omega);
        REQUIRE(close(learner(s, omega, h).t, s.t + h, 0, 1e-13));
        const State<double> same = learner(s, omega, 0);
        REQUIRE((same.t == s.t && close(same.x, s.x, 1e-15) && close(same.v, s.v, 1e-15)));
    }
}

PROPERTY("without a force the ball turns on at the same rate, as far as it gets in h") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const State<double> s = swinging(draw, 2);
        const double h = draw.sign() * draw.real(0.1, 1);
        const State<double> next = learner(s, 0, h);
        REQUIRE(close(next.v, s.v, 1e-15));
        REQUIRE(close(next.x, s.x + h * s.v, 0, 1e-13));
    }
}

PROPERTY("a ball that hangs straight down at rest stays there, however often it has gone round") {
    Draw draw;
    for (int i = 0; i < 20; ++i) {
        const double down = 2 * std::numbers::pi * draw.integer(-3, 3), omega = draw.real(1, 3);
        const State<double> next = learner({0, down, 0}, omega, draw.real(0.1, 0.3));
        // Roundoff: the sine of 6π as a double is 7e-16 instead of zero.
        REQUIRE(close(next.x, down, 0, 1e-13));
        REQUIRE(close(next.v, 0, 0, 1e-13));
    }
}

// What errors of runs over a time of 2/omega fall by when their steps are halved. Several runs
// together: for one alone the first term of the error may happen to be small.
static double measured_order(Draw& draw, int runs, int steps_of_run) {
    double coarse = 0, fine = 0;
    for (int run = 0; run < runs; ++run) {
        const double omega = draw.real(1, 3), end = 2 / omega;
        const State<double> start = swinging(draw, omega), right = exact(start, omega, end);
        const auto error = [&](int steps) {
            State<double> s = start;
            for (int n = 0; n < steps; ++n) s = learner(s, omega, end / steps);
            return std::hypot(s.x - right.x, (s.v - right.v) / omega);
        };
        coarse += error(steps_of_run);
        fine += error(2 * steps_of_run);
    }
    // A run that ends somewhere else has no order.
    return fine < 0.1 ? order(coarse, fine) : 0;
}

// The steps are so short that p and q rounded to four digits no longer pass for the right ones, and
// the errors, about 1e-10, still far above roundoff.
PROPERTY("a run ends where the pendulum ends, and the order of its error is four") {
    Draw draw;
    const double measured = measured_order(draw, 6, 160);
    REQUIRE(measured > 3.8);
    REQUIRE(measured < 4.2);
}

// Steps long enough for the errors of methods that do not run back to show.
PROPERTY("a step forth and a step back lead to where it began") {
    Draw draw;
    for (int i = 0; i < 50; ++i) {
        const double omega = draw.real(1, 3), h = draw.real(0.5, 0.9) / omega;
        const State<double> s = swinging(draw, omega);
        const State<double> back = learner(learner(s, omega, h), omega, -h);
        REQUIRE(close(back.x, s.x, 0, 1e-12));
        REQUIRE(close(back.v, s.v, 0, 1e-12));
    }
}

// What stands before the value of node j in the even polynomial through all nodes, at zero.
template <std::size_t N>
static double weight(const std::array<double, N>& nodes, std::size_t j) {
    double product = 1;
    for (std::size_t i = 0; i < N; ++i)
        if (i != j) product *= nodes[i] * nodes[i] / (nodes[i] * nodes[i] - nodes[j] * nodes[j]);
    return product;
}

// Of small swings a step is a matrix, half of whose trace is cos omega h but for c4 (omega h)⁴ + c6 (omega h)⁶ + …, and
// with order four c4 is zero. Two polynomials give it: one through five amplitudes, for swings so wide that a sine
// which is written as a cosine keeps its digits, and one through seven steps. Roundoff leaves 7e-13 of it. With p and q
// rounded to nine digits it is some 5e-10.
PROPERTY("of the error with the square of the step nothing is left: p and q have all their digits") {
    Draw draw;
    constexpr std::array steps{0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9};
    constexpr std::array parts{0.4, 0.6, 0.8, 1.0, 1.2};
    constexpr int runs = 10;
    double mean = 0;
    for (int run = 0; run < runs; ++run) {
        const double omega = draw.real(1, 3), size = draw.real(0.2, 0.3);
        for (std::size_t i = 0; i < steps.size(); ++i)
            for (std::size_t j = 0; j < parts.size(); ++j) {
                const double wh = steps[i], swing = size * parts[j];
                const State<double> east = learner({0, swing, 0}, omega, wh / omega);
                const State<double> north = learner({0, 0, swing * omega}, omega, wh / omega);
                const double half_trace = (east.x / swing + north.v / (swing * omega)) / 2;
                mean += weight(steps, i) * weight(parts, j) * (half_trace - std::cos(wh)) / std::pow(wh, 4) / runs;
            }
    }
    REQUIRE(std::fabs(mean) <= 5e-12);
}

// A step of order four is wrong by the fifth power of the angles that it goes through, times less than one.
PROPERTY("any step, slow or fast, forth or back, from any angle, ends near where the pendulum ends") {
    Draw draw;
    for (int i = 0; i < 300; ++i) {
        const double omega = i % 5 == 0 ? 0 : draw.any_of(1e-6, 1e4);
        const double size = omega > 0 ? draw.log(1e-6, 1) / omega : draw.log(1e-6, 1e6);
        const double h = draw.sign() * size, t = draw.any_of(0, 1e6, {0});
        const double x = draw.any_of(-20, 20, {0, std::numbers::pi, -std::numbers::pi});
        const State<double> s{t, x, draw.any_of(-1, 1, {0}) / size};
        const State<double> next = learner(s, omega, h), right = exact(s, omega, h, 100);
        const double force = omega * omega * size;
        const double angle = std::max(omega * size, std::fabs(s.v * h));
        const double roundoff = 1e-13 * (std::fabs(s.x) + angle);
        REQUIRE(close(next.t, t + h, 1e-14));
        REQUIRE(close(next.x, right.x, 0, force * size * std::pow(angle, 3) + roundoff));
        REQUIRE(close(next.v, right.v, 0, force * std::pow(angle, 4) + roundoff / size));
    }
}

PROPERTY("no oscillation is too slow or too fast for it, no step too short, and no angle too large") {
    Draw draw;
    for (int i = 0; i < 420; ++i) {
        const double omega = draw.spread(1e-9, 1e9, i, 19), size = draw.spread(1e-12, 1, i, 20) / omega;
        const double h = draw.sign() * size, x = draw.sign() * draw.spread(1e-9, 1e4, i, 21);
        const State<double> s{0, x, i % 3 == 0 ? 0 : draw.sign() * draw.log(1e-9, 10) / size};
        const State<double> next = learner(s, omega, h), right = exact(s, omega, h, 100);
        const double force = omega * omega * size, angle = std::max(omega * size, std::fabs(s.v * h));
        const double roundoff = 1e-13 * (std::fabs(s.x) + angle);
        REQUIRE(close(next.t, h, 1e-14));
        REQUIRE(close(next.x, right.x, 0, force * size * std::pow(angle, 3) + roundoff));
        REQUIRE(close(next.v, right.v, 0, force * std::pow(angle, 4) + roundoff / size));
        const State<double> free = learner(s, 0, h);
        REQUIRE((close(free.v, s.v, 1e-14) && close(free.x, s.x + h * s.v, 0, roundoff)));
    }
}
