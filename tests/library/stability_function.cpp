// The stability functions: each is what the method's own step does.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include <timestep/models/complex_decay.hpp>
#include <timestep/run.hpp>
#include <timestep/stability_function.hpp>

using namespace timestep;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double pi = std::numbers::pi;

using Vector = Eigen::Vector2d;

Vector vector(Complex z) { return {z.real(), z.imag()}; }
Complex number(const Vector& y) { return {y[0], y[1]}; }

// Places all over the plane, |z| from 10⁻³ to 10³.
std::vector<Complex> places() {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> angle(-pi, pi), power(-3, 3);
    std::vector<Complex> all;
    for (int i = 0; i < 300; ++i) {
        const double size = std::pow(10, power(random));
        all.push_back(std::polar(size, angle(random)));
    }
    return all;
}

template <class Method>
constexpr bool a_stable = Method::cost.solves > 0;

}  // namespace

TEST_CASE("a decay's step is a multiplication by R(z), and BDF2's by its root", "[stability_function]") {
    for_each_stability_function([](const auto& method) {
        using Method = std::remove_cvref_t<decltype(method)>;
        for (const Complex z : places()) {
            INFO(method.name << " at z = " << z.real() << " + " << z.imag() << "i");
            const Complex r = stability_function(method, z);
            const double h = 0.25;
            const ComplexDecay model(z / h);
            const FirstOrder<Vector> state1{0, vector({0.6, -0.8})};
            Complex stepped;
            if constexpr (TwoStepMethod<Method, ComplexDecay<double>, FirstOrder<Vector>>) {
                // Where each step multiplies by R, the one before was y₁/R.
                const FirstOrder<Vector> state0{-h, vector(number(state1.y) / r)};
                stepped = number(method.step(model, state0, state1, h).y);
            } else {
                stepped = number(method.step(model, state1, h).y);
            }
            // A stage of size |z| is rounded a few times by ε, and the last of k stages is of size
            // |z|ᵏ; a solve is wrong by ε of its answer for each of the few corrections, of terms
            // that do not cancel: its matrix is a turn times a length. 2m − y₁ and (4y₁ − y₀)/3 are
            // of the size 1 + |R| and 1 + 1/|R| before they shrink.
            double terms = 1, power = 1;
            for (int k = 1; k <= 4; ++k) terms += power *= std::abs(z);
            if (a_stable<Method>) terms = 1 + std::abs(r) + 1 / (std::abs(1.0 - z) * std::abs(r));
            CHECK(std::abs(stepped - r * number(state1.y)) <= 32 * eps * terms);
        }
    });
}

// R has no pole left of the imaginary axis, so there it is largest on the axis (maximum principle).
TEST_CASE("the methods that solve are A-stable, the others are not", "[stability_function][N62]") {
    for_each_stability_function([](const auto& method) {
        using Method = std::remove_cvref_t<decltype(method)>;
        INFO(method.name);
        double most = 0;
        for (double y = 1e-6; y < 1e8; y *= 1.02) {
            most = std::max(most, std::abs(stability_function(method, {0, y})));
            if (a_stable<Method>) {  // and left of it
                for (const double x : {1e-3, 1.0, 1e3})
                    CHECK(std::abs(stability_function(method, {-x, y})) < 1 + 4 * eps);
            }
        }
        CHECK((most <= 1 + 4 * eps) == a_stable<Method>);
    });
}

TEST_CASE("a complex decay turns and shrinks as e^(lambda t)", "[models]") {
    const ComplexDecay model(Complex(-0.5, 3.0));
    const FirstOrder<Vector> start{1, {2, -1}};
    const FirstOrder<Vector> later = model.exact(start, 0.7);
    CHECK(later.t == 1.7);
    // f is the derivative of the exact motion: a central difference is wrong by h²/6 |λ|³ |y|, some
    // 1e-9.
    const double h = 1e-5;
    const Vector slope = (model.exact(start, 0.7 + h).y - model.exact(start, 0.7 - h).y) / (2 * h);
    CHECK((slope - model(0, later.y)).norm() < 1e-8);
    CHECK((model.slope_y(0, later.y) * later.y - model(0, later.y)).norm() < 8 * eps * 3.1 * 3);
    CHECK_THROWS_AS(ComplexDecay(Complex(NAN, 0)), std::invalid_argument);
    CHECK_THROWS_AS(ComplexDecay(Complex(0, INFINITY)), std::invalid_argument);
}

// Where z⁴ is too large for a number, |R| is infinite, and not a NaN that compares with nothing.
TEST_CASE("RK4 far out multiplies by more than any number", "[library]") {
    for (const double size : {1e78, 1e103, 1e150, 1e155, 1e200, 1e308})
        for (double angle = 0; angle < 6.3; angle += 0.1) {
            INFO("z = " << size << " e^(i " << angle << ")");
            CHECK(std::abs(stability_function(runge_kutta_4, std::polar(size, angle))) == INFINITY);
        }
    CHECK(std::abs(stability_function(runge_kutta_4, -1e103)) == INFINITY);
    CHECK(std::abs(stability_function(runge_kutta_4, Complex(0, 1e103))) == INFINITY);
    // And near by it is the series: its terms are 32/3 and less, rounded a few times each.
    const double z = -2, series = 1 + z + z * z / 2 + z * z * z / 6 + z * z * z * z / 24;
    CHECK(std::abs(stability_function(runge_kutta_4, z) - series) < 1e-15);
}
