// The claims of chapter 3 about order, cost and collisions.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

using namespace timestep;

namespace {

const State<double> start{0, 1.0, 0.5};

double distance(const State<double>& a, const State<double>& b) { return std::hypot(a.x - b.x, a.v - b.v); }

// The exact solution, or for the pendulum one whose error is far below those measured here: RK4 with
// 4000 steps a second errs by some (1/4000)⁴/120 < 1e-16 a second.
template <class Model>
State<double> truth(const Model& model, double t) {
    if constexpr (requires { model.exact(start, t); })
        return model.exact(start, t);
    else if (t < 0)
        return [&] {
            State s = start;
            for (int i = 0; i < 4000; ++i) s = runge_kutta_4.step(model, s, t / 4000);
            return s;
        }();
    else
        return run(runge_kutta_4, model, start, t / 8000, 8000);
}

template <class Method, class Model>
double global_order(const Method& method, const Model& model) {
    // Three steps, each half of the one before, over 1.5 s. The short end keeps fourth-order errors,
    // some (ωh)⁴/120, above 1e-13 and the long end keeps the next term of each error below a percent.
    std::vector<double> h, error;
    const State exact = truth(model, 1.5);
    const long base = method.order >= 4 ? 40 : 400;
    for (const long steps : {base, 2 * base, 4 * base}) {
        h.push_back(1.5 / steps);
        error.push_back(distance(run(method, model, start, h.back(), steps), exact));
    }
    return measured_order(h, error);
}

template <class Method, class Model>
double local_order(const Method& method, const Model& model) {
    std::vector<double> h, error;
    // As above: the short end keeps errors of (ωh)⁵/120 well above what rounding leaves.
    const double longest = method.order >= 4 ? 0.04 : 0.02;
    for (const double step : {longest, longest / 2, longest / 4}) {
        State<double> next;
        if constexpr (TwoStepMethod<Method, Model, State<double>>)
            next = method.step(model, truth(model, -step), start, step);
        else
            next = method.step(model, start, step);
        h.push_back(step), error.push_back(distance(next, truth(model, step)));
    }
    return measured_order(h, error);
}

template <class Model>
void hold_to_declared_order(const Model& model) {
    for_each_method([&](const auto& method) {
        INFO(method.name);
        CHECK(std::fabs(global_order(method, model) - method.order) < 0.05);
        CHECK(std::fabs(local_order(method, model) - (method.order + 1)) < 0.05);
    });
}

struct CountedPendulum : Pendulum<double> {
    mutable long forces = 0, slopes = 0;
    using Pendulum::Pendulum;
    double acceleration(double x) const { return ++forces, Pendulum::acceleration(x); }
    double slope_x(double x) const { return ++slopes, Pendulum::slope_x(x); }
};

}  // namespace

TEST_CASE("on a spring every method has its order, and one more for a single step", "[I15][ch3]") {
    hold_to_declared_order(Spring(1.3));
}

TEST_CASE("on a damped spring every method has its order, and one more for a single step", "[I15][ch3]") {
    hold_to_declared_order(DampedSpring(1.3, 0.2));
}

TEST_CASE("on a pendulum every method has its order, and one more for a single step", "[I15][ch3]") {
    hold_to_declared_order(Pendulum(1.3));
}

TEST_CASE("on a smooth spring a higher order needs fewer evaluations for the same accuracy", "[N35][ch3]") {
    const auto evaluations_for = [](const auto& method, double wanted) {
        const Spring spring(1.0);
        for (long steps = 8;; steps = steps * 5 / 4) {
            const State end = run(method, spring, start, 20.0 / steps, steps);
            if (distance(end, spring.exact(start, 20.0)) < wanted) return steps * method.cost.evaluations;
        }
    };
    const long euler = evaluations_for(semi_implicit_euler, 1e-3);
    const long second = evaluations_for(midpoint, 1e-3);
    const long fourth = evaluations_for(runge_kutta_4, 1e-3);
    CHECK(second < euler);
    CHECK(fourth < second);
}

TEST_CASE("every method steps the same scenes", "[N35][ch3]") {
    for_each_method([](const auto& method) {
        INFO(method.name);
        const Scene ball{Projectile(-9.81), Drag(0.1)};
        const State end = run(method, ball, State{0, 10.0, 0.0}, 0.001, 1000);
        // Falling with drag from rest: v = −w tanh(gt/w), w = √(g/k); first order is off by some h g.
        const double w = std::sqrt(9.81 / 0.1);
        CHECK(std::fabs(end.v + w * std::tanh(9.81 / w)) < 0.001 * 9.81);
        CHECK(std::fabs(end.x - (10 - w * w / 9.81 * std::log(std::cosh(9.81 / w)))) < 0.001 * 9.81);
    });
}

// A ball that falls from rest through air and bounces once, exactly. With w the terminal speed,
// falling: v = −w tanh(gt/w), x = x₀ − (w²/g) ln cosh(gt/w); rising from the ground at speed u:
// v = w tan(φ − gt/w), x = (w²/g) ln(cos(φ − gt/w)/cos φ), φ = arctan(u/w).
TEST_CASE("a collision brings every order down to one", "[N36][ch3]") {
    const double g = 9.81, w = 4, restitution = 0.8;
    const Scene ball{Projectile(-g), Drag<double>::from_terminal_speed(w, g)};
    const auto exact_height = [&](double drop, double t) {
        const double landing = w / g * std::acosh(std::exp(drop * g / (w * w)));
        if (t < landing) return drop - w * w / g * std::log(std::cosh(g * t / w));
        const double phi = std::atan(restitution * std::tanh(g * landing / w));
        return w * w / g * std::log(std::cos(phi - g * (t - landing) / w) / std::cos(phi));
    };
    const auto order = [&](const auto& method, double seconds, long coarsest, long finest) {
        std::vector<double> h, error;
        for (long steps = coarsest; steps <= finest; steps *= 2) {
            double sum = 0;
            for (int phase = 0; phase < 60; ++phase) {
                const double drop = 1 + 0.3 * phase / 60;
                State s{0, drop, 0.0};
                for (long i = 0; i < steps; ++i) {
                    s = method.step(ball, s, seconds / steps);
                    if (s.x < 0) s = {s.t, -restitution * s.x, -restitution * s.v};
                }
                sum += std::fabs(s.x - exact_height(drop, seconds));
            }
            h.push_back(seconds / steps), error.push_back(sum / 60);
        }
        return measured_order(h, error);
    };
    // In the air for 0.4 s: the order that each declares.
    CHECK(std::fabs(order(runge_kutta_4, 0.4, 32, 256) - 4) < 0.1);
    CHECK(std::fabs(order(semi_implicit_euler, 0.4, 32, 256) - 1) < 0.1);
    // After 0.7 s all have bounced once and still rise. A single error lies anywhere between 0 and some h; the mean of
    // 60 jitters by 1/√(3·60), 7 %, so two of them seven octaves apart leave the slope within 0.1.
    CHECK(std::fabs(order(runge_kutta_4, 0.7, 32, 4096) - 1) < 0.1);
    CHECK(std::fabs(order(midpoint, 0.7, 32, 4096) - 1) < 0.1);
    CHECK(std::fabs(order(semi_implicit_euler, 0.7, 32, 4096) - 1) < 0.1);
}

// By when a step has ended that goes below the ground, at 60 Hz. From rest the exact landing is (w/g) arcosh exp(g
// x₀/w²).
TEST_CASE("RK4 turns a ball too late every time, semi-implicit Euler now early, now late", "[N36][ch3]") {
    const double g = 9.81, w = 4;
    const Scene ball{Projectile(-g), Drag<double>::from_terminal_speed(w, g)};
    const auto late = [&](const auto& method) {
        struct {
            double least = 1, most = -1, mean = 0;
        } by;
        for (int phase = 0; phase < 60; ++phase) {
            State s{0, 1 + 0.3 * phase / 60, 0.0};
            const double landing = w / g * std::acosh(std::exp(s.x * g / (w * w)));
            while (s.x >= 0) s = method.step(ball, s, 1.0 / 60);
            by.least = std::min(by.least, s.t - landing), by.most = std::max(by.most, s.t - landing);
            by.mean += (s.t - landing) / 60;
        }
        return by;
    };
    const auto fourth = late(runge_kutta_4);
    const auto semi = late(semi_implicit_euler);
    CHECK(fourth.least > 0);
    CHECK(fourth.most < 1.0 / 60 * 1.001);  // within the step in which it lands, whatever RK4's own error
    CHECK(std::fabs(fourth.mean - 0.5 / 60) < 0.1 / 60);
    CHECK(semi.least < -0.5 / 60);
    CHECK(semi.most > 0.25 / 60);
    CHECK(std::fabs(semi.mean) < fourth.mean / 2);
}

TEST_CASE("implicit Euler pays with solves and gets stability", "[I05][ch3]") {
    const CountedPendulum explicit_one(1.0), implicit_one(1.0);
    const long steps = 1000;
    run(semi_implicit_euler, explicit_one, start, 0.1, steps);
    run(implicit_euler, implicit_one, start, 0.1, steps);
    CHECK(explicit_one.forces == steps);
    CHECK(explicit_one.slopes == 0);
    // At least one Newton round, and one more to see that it has converged.
    CHECK(implicit_one.forces >= 2 * steps);
    CHECK(implicit_one.slopes >= 2 * steps);
    // On a spring a hundred times too stiff for the explicit methods it goes on, and to rest.
    const Spring stiff(200.0);
    const State calm = run(implicit_euler, stiff, start, 1.0, 10);
    const State wild = run(semi_implicit_euler, stiff, start, 1.0, 10);
    CHECK(std::hypot(calm.x, calm.v / 200) < 1e-10);
    CHECK(std::hypot(wild.x, wild.v / 200) > 1e10);
}
