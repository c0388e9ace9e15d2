// I13, I15: which steps the advice calls right, against runs with them.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include <timestep/run.hpp>

#include "advice_of.hpp"
#include "method_on_spring.hpp"

using namespace timestep;

namespace {

// What the reader sees: let go at rest, the largest distance of a run from the exact positions in the first swing.
template <class Method>
double off(const Method& method, const DampedSpring<double>& spring, double h) {
    const double slow = spring.zeta < 1 ? spring.omega : spring.omega / detail::fast_decay(spring.zeta);
    const auto fit = static_cast<long>(2 * std::numbers::pi / (slow * h) * (1 + 1e-12));
    const State<double> start{0, 1, 0};
    double most = 0;
    long n = 0;
    const auto look = [&](const State<double>& s) {
        most = std::max(most, std::abs(s.x - spring.exact(start, h * double(n++)).x));
    };
    if constexpr (Method::takes_damping)
        run(method, spring, start, h, fit < 3 ? 8 : fit, look);
    else
        run(method, Spring<double>(spring.omega), start, h, fit < 3 ? 8 : fit, look);
    return most;
}

template <class Method>
Advice advise_on(const Method& method, const DampedSpring<double>& spring, double h) {
    return advise(on_spring(method, spring.zeta, spring.zeta), spring, h, 0.01);
}

}  // namespace

TEST_CASE("a step that is right to 1 % shows a motion that is, and a longer one does not", "[library][I13][I15]") {
    for (const double zeta : {0.1, 0.5, 0.9, 0.99, 1.0, 1.01, 1.1, 5.0}) {
        const DampedSpring<double> spring(1.0, zeta);
        for_each_damped([&](const auto& method) {
            const Advice advice = of(advise(spring, 0.01, 0.01), method.name);
            const double h = advice.accurate_step;
            CAPTURE(zeta, method.name, h);
            REQUIRE(h > 0);
            for (const double share : {0.1, 0.3, 0.6, 0.9, 0.99, 0.9999}) CHECK(off(method, spring, share * h) <= 0.01);
            bool ends_there = false;  // the error has teeth: a little beyond, a step may be right again
            for (const double share : {1.0001, 1.001, 1.003, 1.01, 1.03, 1.06}) {
                const Advice longer = advise_on(method, spring, share * h);
                ends_there = ends_there || off(method, spring, share * h) > 0.01 || longer.ringing < 0 ||
                             longer.verdict != Verdict::stable;
            }
            CHECK(ends_there);
        });
    }
}

// Up to thousands of steps a swing, and dampers that are over in a few of them.
TEST_CASE("the position error, sampled, is that of every step of a run", "[library][I13]") {
    std::mt19937_64 numbers(21);
    std::uniform_real_distribution<double> even;
    double worst = 0;
    const auto measure = [&](const auto& method) {
        constexpr bool damped = std::remove_cvref_t<decltype(method)>::takes_damping;
        for (int i = 0; i < 60; ++i) {
            const double zeta = damped && i % 4 ? 0.01 * std::pow(1e4, even(numbers)) : 0;
            const double h = 5e-4 * std::pow(1e4, even(numbers));
            const double said = on_spring(method, zeta, zeta).position_error(h);
            const double seen = off(method, DampedSpring<double>(1.0, zeta), h);
            if (!(seen < 1e3)) continue;
            CAPTURE(method.name, zeta, h, said, seen);
            CHECK(std::abs(said - seen) <= 2e-4 * seen + 1e-11);
            if (seen > 1e-8) worst = std::max(worst, std::abs(said / seen - 1));
        }
    };
    for_each_method(measure);
    measure(semi_implicit_euler_new_damping);
    for_each_verlet_method(measure);
    CHECK(worst < 1e-4);
}

TEST_CASE("an asked step is right when its own error is small, and then a run is", "[library][I13][I15]") {
    std::mt19937_64 numbers(12);
    std::uniform_real_distribution<double> even;
    long right = 0;
    for_each_damped([&](const auto& method) {
        for (int i = 0; i < 300; ++i) {
            const DampedSpring<double> spring(1.0, 0.05 * std::pow(100, even(numbers)));
            const double h = 0.01 * std::pow(1000, even(numbers));
            const Advice advice = advise_on(method, spring, h);
            CAPTURE(method.name, spring.zeta, h, advice.position_error);
            if (advice.accurate_step > 1.001 * h) CHECK(advice.right);
            if (!advice.right) continue;
            CHECK(advice.verdict == Verdict::stable);
            CHECK(off(method, spring, h) <= 0.01 * (1 + 1e-6));
            ++right;
        }
    });
    CHECK(right > 300);
}

// A step changes x by 4.5e-17 of it: less than half of what double can tell from one. So it stays where
// it is, but for the first three digits below one.
TEST_CASE("a step whose change is lost in roundoff is not right", "[library][I13]") {
    const DampedSpring<double> spring(1.0, 1e8);
    const double h = 0.9e-8;
    CHECK(run(explicit_euler, spring, State<double>{0, 1, 0}, h, 10'000).x > 1 - 1e-15);
    const auto all = advise(spring, h);
    for (const Advice& advice : all) {
        CAPTURE(advice.method);
        CHECK_FALSE(advice.right);
        CHECK(best_step(advice, h) == 0);
        if (advice.verdict != Verdict::refused) CHECK(advice.rate_error >= 1);
    }
    CHECK(cheapest(all, h) == nullptr);
    CHECK(cheapest(all) != nullptr);
    CHECK(of(all, "implicit Euler").accurate_from > h);
}

// The advice's word against the run: a kick, and how often the velocity turns its sign. A multiplier below
// −1/2 that is real turns it at every step, a complex one at two of three; the true motion after a kick
// turns once where it swings no more.
TEST_CASE("a velocity that is said to ring changes its sign step by step", "[library][I13]") {
    std::mt19937_64 numbers(11);
    std::uniform_real_distribution<double> even;
    long ringing = 0, methods = 0;
    const auto turns = [&](const auto& method, const auto& spring, double h) {
        int count = 0;
        double before = 0;
        run(method, spring, State<double>{0, 0, 1}, h, 9, [&](const State<double>& state) {
            count += before * state.v < 0;
            before = state.v;
        });
        return count;
    };
    const auto measure = [&](const auto& method) {
        bool any = false;
        for (int i = 0; i < 150; ++i) {
            const DampedSpring<double> spring(1.0, 0.6 * std::pow(200, even(numbers)));
            const double h = std::pow(10, -3 + 6 * even(numbers));
            const Advice advice = advise_on(method, spring, h);
            if (advice.verdict != Verdict::stable) continue;
            CAPTURE(method.name, spring.zeta, h, advice.reason);
            if (advice.ringing < 0) {
                CHECK(advice.ringing < -0.5);
                CHECK(advice.reason.starts_with("stable, but rings"));
                CHECK(turns(method, spring, h) >= 4);
                CHECK(advice.accurate_step < h);
                any = true, ++ringing;
            }
        }
        methods += any;
    };
    for_each_damped(measure);
    CHECK(ringing > 20);
    CHECK(methods >= 4);  // explicit Euler, both semi-implicit ones, implicit midpoint, the constant force
}
