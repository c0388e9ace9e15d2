// The claims of chapter 3 about order, cost and collisions.

#include <catch2/catch_test_macros.hpp>

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

TEST_CASE("on a damped spring every method has its order, and one more for a single step", "[I15][ch3]") {
    hold_to_declared_order(DampedSpring(1.3, 0.2));
}

TEST_CASE("on a pendulum every method has its order, and one more for a single step", "[I15][ch3]") {
    hold_to_declared_order(Pendulum(1.3));
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
