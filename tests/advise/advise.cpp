// I13: the advice on a spring, against what the methods really do.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>

#include <timestep/models/spring.hpp>
#include <timestep/multipliers.hpp>

#include <timestep/run.hpp>

#include "advice_of.hpp"

using namespace timestep;

namespace {

constexpr double zetas[] = {0, 1e-6, 1e-3, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 1, 1.1, 2, 10, 1000};

// What a step multiplies the amplitude by, from the method's own step.
template <class Method>
double growth(const Method& method, double zeta, double s) {
    double largest = 0;
    for (const auto& lambda : detail::multipliers(method, zeta, s))
        largest = std::max(largest, static_cast<double>(std::abs(lambda)));
    return largest;
}

}  // namespace

// Just below the limit nothing grows, just above it something does; and the whole way below it is
// stable, so that the limit is the first.
TEST_CASE("the formulas for the longest stable step are those of the steps' eigenvalues",
          "[library][N23][N25][N33][I13]") {
    const auto holds = [](const auto& method) {
        constexpr bool damped = std::remove_cvref_t<decltype(method)>::takes_damping;
        for (const double zeta : zetas) {
            if (!damped && zeta > 0) continue;
            CAPTURE(method.name, zeta);
            const double limit = stability_limit(method, zeta).value;
            // 1e-14 for roundoff: λ comes from numbers of size one in long double.
            if (std::isinf(limit)) {
                for (double s = 1e-3; s < 1e9; s *= 3) CHECK(growth(method, zeta, s) <= 1 + 1e-14);
            } else if (limit > 0) {
                for (int i = 1; i <= 200; ++i) CHECK(growth(method, zeta, 0.9999 * limit * i / 200) <= 1 + 1e-14);
                CHECK(growth(method, zeta, 1.0001 * limit) > 1);
            } else {
                for (double s = 0.01; s < 10; s *= 1.3) CHECK(growth(method, zeta, s) > 1);
            }
        }
    };
    for_each_method(holds);
    holds(semi_implicit_euler_new_damping);
    for_each_verlet_method(holds);
}

namespace {
template <class Method>
struct WithoutFormula : Method {};  // the search, as the type is another
}  // namespace

TEST_CASE("the limit of a method without a formula is found by search", "[library][I13]") {
    const auto holds = [](const auto& method) {
        for (const double zeta : {0.0, 0.1, 0.5, 1.0, 3.0, 1000.0}) {
            if (!method.takes_damping && zeta > 0) continue;
            CAPTURE(method.name, zeta);
            const double limit = stability_limit(method, zeta).value;
            const double found = stability_limit(WithoutFormula<std::decay_t<decltype(method)>>{}, zeta).value;
            if (std::isinf(limit))
                CHECK(std::isinf(found));
            else
                CHECK(std::abs(found - limit) <= 1e-6 * limit + 1e-3 * (limit == 0));
        }
    };
    holds(explicit_euler), holds(semi_implicit_euler), holds(heun), holds(runge_kutta_4);
    holds(implicit_midpoint), holds(leapfrog), holds(semi_implicit_euler_new_damping);
}

// The run's amplitude is read at two moments a whole number of swings apart as nearly as steps allow:
// growth of a few swings' length, to a hundredth of its logarithm.
TEST_CASE("the predicted growth a second is what a run of a second shows", "[library][I13]") {
    const DampedSpring<double> spring(20.0, 0.05);
    const double h = 1.0 / 240;
    const auto all = advise(spring, h);
    const auto measure = [&](const auto& method) {
        if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(method)>, Verlet>) {
            CAPTURE(method.name);
            const Advice advice = of(all, method.name);
            double first = 0, last = 0;
            long n = 0;
            const long steps = 240 * 4, swing = 76;  // 2π/20 s is 75.4 steps
            run(method, spring, State<double>{0, 1, 0}, h, steps, [&](const State<double>& s) {
                const double size = std::hypot(s.x, s.v / 20);
                if (n < swing) first = std::max(first, size * std::pow(advice.growth_per_step, -double(n)));
                if (n > steps - swing)
                    last = std::max(last, size * std::pow(advice.growth_per_step, double(steps - n)));
                ++n;
            });
            CHECK(std::abs(std::log(last / first) / 4 - std::log(advice.growth_per_second)) < 0.03);
        }
    };
    for_each_method(measure);
    measure(semi_implicit_euler_new_damping);
    measure(constant_acceleration);
}

// A step turns by the angle θ with 2 sin θ/2 = ωh.
TEST_CASE("the predicted period of semi-implicit Euler is that of its closed form", "[library][I13]") {
    const auto all = advise(DampedSpring<double>(30.0, 0.0), 1.0 / 60);
    const double exact = 0.5 / (2 * std::asin(0.5 / 2)) - 1;
    for (const char* name : {"semi-implicit Euler", "Verlet", "leapfrog"})
        CHECK(std::abs(of(all, name).period_error - exact) < 1e-12);
}

TEST_CASE("a step within a thousandth of the limit is too close to call", "[library][I13]") {
    for (const double zeta : {0.01, 0.3, 2.0}) {
        const double limit = stability_limit(semi_implicit_euler, zeta).value;
        const auto verdict_at = [&](double s) {
            return of(advise(DampedSpring<double>(10.0, zeta), s / 10), "semi-implicit Euler").verdict;
        };
        CHECK(verdict_at(limit) == Verdict::too_close_to_call);
        CHECK(verdict_at(limit * 0.9995) == Verdict::too_close_to_call);
        CHECK(verdict_at(limit * 0.998) == Verdict::stable);
        CHECK(verdict_at(limit * 1.002) == Verdict::grows);
    }
}

TEST_CASE("Verlet's methods are refused with a damper and advised on without one", "[library][I08][I13]") {
    for (const char* name : {"Verlet", "velocity Verlet", "leapfrog"}) {
        CHECK(of(advise(DampedSpring<double>(10.0, 0.1), 0.01), name).verdict == Verdict::refused);
        CHECK(of(advise(DampedSpring<double>(10.0, 0.0), 0.01), name).verdict == Verdict::stable);
    }
}

TEST_CASE("the reason has as many digits as tell the step from the limit", "[library][I13]") {
    const auto why = [](double h) { return of(advise(DampedSpring<double>(10.0, 0.0), h), "Verlet").reason; };
    CHECK(why(0.2) == "ωh = 2, the limit itself");
    CHECK(why(0.1) == "ωh = 1 < 2");
    CHECK(why(0.20000001) == "ωh = 2, the limit itself");
    CHECK(why(0.19999) == "ωh = 1.9999 < 2");
}
