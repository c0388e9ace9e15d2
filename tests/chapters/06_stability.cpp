// The claims of chapter 6 about convergence, and about what stays bounded.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_function.hpp>

using namespace timestep;

namespace {

struct Always42 {
    template <class Model, class X>
    State<X> step(const Model&, const State<X>& state1, real_of<X> h) const {
        return {state1.t + h, 42, 0};
    }
};

template <class Method, class Model>
double order(const Method& method, const Model& model, const State<double>& start, const State<double>& exact,
             double seconds) {
    std::vector<double> h, error;
    for (const int steps : {64, 128, 256, 512}) {
        h.push_back(seconds / steps);
        const State end = run(method, model, start, h.back(), steps);
        error.push_back(std::hypot(end.x - exact.x, end.v - exact.v));
    }
    return measured_order(h, error);
}

// The farthest that a run of 20,000 steps goes.
template <class Method, class Model>
double reach(const Method& method, const Model& model, double h) {
    double most = 0;
    run(method, model, State{0, 1.0, 0.0}, h, 20000, [&](const auto& s) {
        const double size = std::hypot(s.x, s.v);
        most = std::isfinite(size) ? std::max(most, size) : 1e300;
    });
    return most;
}

}  // namespace

// The error is C hᵖ (1 + c h) with c of a few 1/s, and h is 0.01 s: slopes are off by a few
// hundredths.
TEST_CASE("every method converges with its order on smooth scenes", "[N60][ch6]") {
    const State<double> start{0, 1.0, 0.3}, rest{0, 0.0, 0.0};
    const Spring spring(1.0);
    const DampedSpring damped(1.0, 0.3);
    const double speed = 4, g = 9.81, t = 2;
    const Scene fall{Projectile(-g), Drag<double>::from_terminal_speed(speed, g)};
    const State<double> fallen{t, -speed * speed / g * std::log(std::cosh(g * t / speed)),
                               -speed * std::tanh(g * t / speed)};
    const auto on_springs = [&](const auto& method) {
        INFO(method.name);
        CHECK(std::fabs(order(method, spring, start, spring.exact(start, t), t) - method.order) < 0.1);
        CHECK(std::fabs(order(method, damped, start, damped.exact(start, t), t) - method.order) < 0.1);
    };
    for_each_method(on_springs);
    on_springs(constant_acceleration), on_springs(semi_implicit_euler_new_damping);
    for_each_verlet_method([&](const auto& method) {  // those take no damper
        INFO(method.name);
        CHECK(std::fabs(order(method, spring, start, spring.exact(start, t), t) - method.order) < 0.1);
    });
    for_each_method([&](const auto& method) {
        INFO(method.name);
        CHECK(std::fabs(order(method, fall, rest, fallen, t) - method.order) < 0.1);
    });
}

TEST_CASE("the answer 42 is bounded and does not converge", "[N60][N62][ch6]") {
    const State<double> start{0, 1.0, 0.3};
    const Spring spring(1.0);
    CHECK(std::fabs(order(Always42{}, spring, start, spring.exact(start, 2.0), 2)) < 1e-9);
    CHECK(reach(Always42{}, spring, 100) == 42);
}

// Bounded where every factor is one at most: a step matrix's, or R(z) of the spring's two decays.
TEST_CASE("a run stays bounded where its step's factors say so, and grows elsewhere", "[N62][ch6]") {
    for (const double zeta : {0.0, 0.2, 0.5, 1.5}) {
        for (const double wh : {0.3, 0.7, 1.1, 1.6, 2.4, 3.1, 6.3}) {
            const DampedSpring model(1.0, zeta);
            const Complex root = std::sqrt(Complex(zeta * zeta - 1));
            const auto compare = [&](const auto& method, double factor) {
                INFO(method.name << " with zeta = " << zeta << ", omega h = " << wh);
                const bool grows = factor > 1 + 1e-12;
                // Within a thousandth of one, 20,000 steps do not tell.
                if (std::fabs(factor - 1) < 1e-3 && grows) return;
                // What does not grow may reach, on a thin ellipse or near a double root, some
                // 1/(1 − |λ|) times its start; a growth of a thousandth a step is e²⁰ in the end.
                CHECK((reach(method, model, wh) > 1e5) == grows);
            };
            for_each_stability_function([&](const auto& method) {
                compare(method, std::max(std::abs(stability_function(method, wh * (-zeta + root))),
                                         std::abs(stability_function(method, wh * (-zeta - root)))));
            });
            const auto by_matrix = [&](const auto& method) {
                compare(method, spectral_radius(step_matrix(method, model, wh)));
            };
            by_matrix(semi_implicit_euler), by_matrix(semi_implicit_euler_new_damping),
                by_matrix(constant_acceleration);
        }
    }
    for (const double wh : {0.3, 1.1, 1.9, 2.1, 5.0}) {
        const Spring model(1.0);
        CHECK((reach(verlet, model, wh) > 1e5) == (wh > 2));
        CHECK((reach(velocity_verlet, model, wh) > 1e5) == (wh > 2));
        CHECK((reach(leapfrog, model, wh) > 1e5) == (wh > 2));
    }
}
