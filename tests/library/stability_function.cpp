// Stability functions: what a step multiplies a motion e^(λt) by (N60, N62).
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <complex>

#include <timestep/measured_order.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_function.hpp>

using namespace timestep;

namespace {

using Complex = std::complex<double>;

// Calls visit(method) for each method that has a stability function.
template <class Visit>
void for_each_with_function(const Visit& visit) {
    visit(explicit_euler), visit(implicit_euler), visit(midpoint), visit(heun);
    visit(implicit_midpoint), visit(bdf2), visit(runge_kutta_4);
}

}  // namespace

// e^z and R(z) agree up to z^p: their difference falls with the order p + 1.
TEST_CASE("a stability function is e^z up to the order of its method", "[N60][I15][library]") {
    for_each_with_function([](const auto& method) {
        CAPTURE(method.name);
        for (const double angle : {0.0, 0.7, 1.6, 3.1}) {
            std::vector<double> sizes, errors;
            for (const double size : {0.02, 0.01, 0.005}) {
                const Complex z = std::polar(size, angle);
                sizes.push_back(size);
                errors.push_back(std::abs(stability_function(method, z) - std::exp(z)));
            }
            CHECK(std::abs(measured_order(sizes, errors) - (method.order + 1)) < 0.1);
        }
    });
}

// A real decay: one step of a one-step method is R to roundoff. BDF2's run tends to it as the second root,
// 1/(2 + √(1 + 2z)), fades against the first: for these z by a factor of two a step or more.
TEST_CASE("a step multiplies a decay by the stability function", "[N62][library]") {
    for (const double z : {-0.1, -0.3, 0.3}) {
        const Decay decay(z);
        for_each_with_function([&](const auto& method) {
            CAPTURE(method.name, z);
            const double R = stability_function(method, Complex(z)).real();
            FirstOrder<double> before{0, 1}, state = before;
            if constexpr (TwoStepMethod<std::remove_cvref_t<decltype(method)>, Decay<double>, FirstOrder<double>>) {
                state = method.start(decay, before, 1.0);
                for (int i = 0; i < 60; ++i) {
                    const auto next = method.step(decay, before, state, 1.0);
                    before = state, state = next;
                }
                CHECK(std::abs(state.y / before.y - R) < 1e-14 * 4);
            } else {
                CHECK(std::abs(method.step(decay, before, 1.0).y - R) < 1e-15 * 4);
            }
        });
    }
}

// By the maximum principle |R| is largest on the edge of a region that has no pole in it: for the left half
// plane that is the imaginary axis and infinity.
TEST_CASE("implicit Euler, implicit midpoint and BDF2 are A-stable, the explicit methods are not", "[N62][library]") {
    const auto largest = [](const auto& method) {
        double most = 0;
        for (int i = -300; i <= 300; ++i)
            for (const double sign : {-1.0, 1.0})
                most = std::max(most, std::abs(stability_function(method, Complex(0, sign * std::pow(10, i / 20.0)))));
        return most;
    };
    CHECK(largest(implicit_euler) <= 1 + 1e-15);
    CHECK(largest(implicit_midpoint) <= 1 + 1e-15);
    CHECK(largest(bdf2) <= 1 + 1e-15);
    for (const double z : {-2.1, -3.0, -100.0}) {
        CHECK(std::abs(stability_function(explicit_euler, Complex(z))) > 1);
        CHECK(std::abs(stability_function(midpoint, Complex(z))) > 1);
    }
    CHECK(std::abs(stability_function(runge_kutta_4, Complex(-2.8))) > 1);
    CHECK(std::abs(stability_function(runge_kutta_4, Complex(-2.78))) < 1);
}

// |R| = 1/(1 + |z|), 1/(√(2|z|) − 2) or so, and |1 + z/2|/|1 − z/2| → 1.
TEST_CASE("implicit Euler and BDF2 are L-stable, implicit midpoint is not", "[N62][library]") {
    const Complex far(-1e12);
    CHECK(std::abs(stability_function(implicit_euler, far)) < 2e-12);
    CHECK(std::abs(stability_function(bdf2, far)) < 1e-6);
    CHECK(std::abs(std::abs(stability_function(implicit_midpoint, far)) - 1) < 1e-11);
    CHECK(stability_function(implicit_midpoint, far).real() < 0);
}

TEST_CASE("implicit midpoint keeps the size of every swing, the others of none or of some", "[N62][library]") {
    for (double s = 1e-3; s < 1e6; s *= 3) {
        CHECK(std::abs(spectral_radius(step_matrix(implicit_midpoint, Spring(1.0), s)) - 1) < 1e-12);
        CHECK(spectral_radius(step_matrix(implicit_euler, Spring(1.0), s)) < 1);
        CHECK(spectral_radius(step_matrix(explicit_euler, Spring(1.0), s)) > 1);
    }
}

// Bounded where the exact motion is BOUNDED: the talk's text says unbounded. A spring that is pushed apart
// (ω² < 0) has an exact motion that grows; a method that follows it is not unstable for that.
TEST_CASE("stability is asked where the exact motion is bounded", "[N62][library]") {
    const Decay growing(1.0), fading(-1.0);
    const auto end = [&](const auto& method, const Decay<double>& model) {
        return run(method, model, FirstOrder<double>{0, 1}, 0.1, 1000).y;
    };
    CHECK(end(explicit_euler, growing) > 1e40);  // 1.1^1000, as it should: the exact motion is e^100
    CHECK(end(implicit_euler, growing) > 1e40);
    CHECK(end(explicit_euler, fading) < 1e-40);
    CHECK(end(implicit_euler, fading) < 1e-40);
}
