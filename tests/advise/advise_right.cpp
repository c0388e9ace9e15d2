// I13, I15: which steps the advice calls right, against runs with them.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numbers>
#include <random>

#include "method_on_spring.hpp"
#include <timestep/run.hpp>

using namespace timestep;

namespace {

Advice of(const std::vector<Advice>& all, const std::string& method) {
    for (const Advice& advice : all)
        if (advice.method == method) return advice;
    FAIL("no advice on " << method);
    return all.front();
}

}  // namespace

// Half the error wanted: a method of order p needs a step shorter by 2^(−1/p).
TEST_CASE("the step for an accuracy is as long as the method's order says", "[library][I13][I15]") {
    const DampedSpring<double> spring(10.0, 0.2);
    const auto coarse = advise(spring, 0.01, 1e-4), fine = advise(spring, 0.01, 1e-4 / 16);
    const auto order_of = [&](const char* name) {
        return std::log(16.0) / std::log(of(coarse, name).accurate_step / of(fine, name).accurate_step);
    };
    for (const char* name : {"explicit Euler", "implicit Euler", "semi-implicit Euler", "constant acceleration"})
        CHECK(std::abs(order_of(name) - 1) < 0.05);
    for (const char* name : {"midpoint", "Heun", "implicit midpoint", "BDF2"})
        CHECK(std::abs(order_of(name) - 2) < 0.05);
    CHECK(std::abs(order_of("Runge-Kutta 4") - 4) < 0.1);
    REQUIRE(cheapest(fine) != nullptr);
    CHECK(cheapest(fine)->method == "Runge-Kutta 4");
}

// There the two exponents of the motion are one, and a change of the spring by ε splits them by √ε: a
// method is not wrong by that.
TEST_CASE("at zeta = 1 the step for an accuracy is about as long as beside it", "[library][I13][I15]") {
    std::vector<Advice> before;
    for (const double zeta : {0.99, 0.9999, 1.0, 1.0001, 1.01}) {
        const auto all = advise(DampedSpring<double>(10.0, zeta), 0.01, 0.01);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].verdict == Verdict::refused) continue;
            CAPTURE(zeta, all[i].method, all[i].accurate_step);
            CHECK(all[i].accurate_step > 0);
            if (!before.empty()) CHECK(std::abs(std::log(all[i].accurate_step / before[i].accurate_step)) < 0.2);
        }
        before = all;
    }
}

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

// How far the rate of its decay is off when the fast part is gone.
template <class Method>
double slow_off(const Method& method, const DampedSpring<double>& spring, double h) {
    const long steps = std::max(40L, std::lround(8 / (spring.omega * h)));
    const State<double> start{0, 1, 0}, middle = run(method, spring, start, h, steps);
    const double end = run(method, spring, start, h, 2 * steps).x;
    const double slow = spring.omega / detail::fast_decay(spring.zeta);
    return std::abs(std::log(middle.x / end) / (double(steps) * h) / slow - 1);
}

template <class Method>
Advice advise_on(const Method& method, const DampedSpring<double>& spring, double h) {
    return advise(on_spring(method, spring.zeta, spring.zeta), spring, h, 0.01);
}

// Every method that steps a damper and has one state.
template <class Visit>
void for_each_damped(const Visit& visit) {
    for_each_method([&](const auto& method) {
        if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(method)>, Bdf2>) visit(method);
    });
    visit(semi_implicit_euler_new_damping);
    visit(constant_acceleration);
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

// Chapter 6's example: a size between 0.74 and 1.25, and far off all the same.
TEST_CASE("semi-implicit Euler at omega h = 0.84 has a fair rate and a position that is far off", "[library][I13]") {
    const Advice advice = of(advise(DampedSpring<double>(1.0, 0.0), 0.84), "semi-implicit Euler");
    CHECK(advice.verdict == Verdict::stable);
    CHECK(advice.rate_error < 0.04);
    CHECK(advice.position_error > 0.4);
    CHECK(std::abs(advice.position_error - off(semi_implicit_euler, DampedSpring<double>(1.0, 0.0), 0.84)) < 1e-12);
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

// There implicit Euler multiplies the fast part by 0.0747 a step, as the slow one should be. The slow one
// it multiplies by 0.277.
TEST_CASE("the fast part's decay is not taken for the slow one's", "[library][I13]") {
    const DampedSpring<double> spring(1.0, 1.318);
    const Advice advice = of(advise(spring, 5.6885), "implicit Euler");
    CHECK(slow_off(implicit_euler, spring, 5.6885) > 0.5);
    CHECK_FALSE(advice.right);
    CHECK(advice.rate_error > 0.5);
}

TEST_CASE("who asks for less is not offered shorter steps", "[library][I13]") {
    for (const double zeta : {0.0, 1e-5, 1e-3, 0.03, 0.1, 0.4, 1.0, 1.3, 30.0, 1e5, 1e9}) {
        std::vector<Advice> before;
        for (const double wanted : {1e-4, 1e-3, 0.01, 0.05, 0.2, 0.5}) {
            const auto all = advise(DampedSpring<double>(100.0, zeta), 1e-5, wanted);
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (before.empty()) break;
                CAPTURE(zeta, wanted, all[i].method);
                CHECK(all[i].accurate_step >= before[i].accurate_step * (1 - 1e-9));
                CHECK(all[i].right >= before[i].right);
            }
            before = all;
        }
    }
    // Below ζ = 0.005 explicit Euler is stable only for steps far shorter than 5 % would allow.
    const auto loose = advise(DampedSpring<double>(100.0, 0.001), 1e-5, 0.05);
    for (const char* name : {"explicit Euler", "constant acceleration"}) {
        CHECK(of(loose, name).right);
        CHECK(of(loose, name).accurate_step > 1.9e-5);
    }
    const auto close = advise(DampedSpring<double>(100.0, 0.001), 1.9999e-5, 0.05);
    CHECK_FALSE(of(close, "explicit Euler").right);  // too close to call
    CHECK(of(close, "explicit Euler").accurate_step < 1.9981e-5);
}

// The slow decay alone is left, e^(−t), by steps of z = s/(2ζ) of its time.
TEST_CASE("however hard the damper, the methods without a limit are right up to the same share", "[library][I13]") {
    const auto off_by_a_percent = [](const auto& left) {  // how long z is then; left(n, z) is what n steps leave
        double low = 1e-3, high = 1;
        for (int i = 0; i < 40; ++i) {
            const double z = (low + high) / 2;
            double most = 0;
            for (int n = 1; n * z <= 6.28; ++n) most = std::max(most, std::abs(left(n, z) - std::exp(-n * z)));
            (most <= 0.01 ? low : high) = z;
        }
        return low;
    };
    const double euler = off_by_a_percent([](int n, double z) { return std::pow(1 + z, -n); });
    const double two_steps = off_by_a_percent([](int n, double z) {
        double before = 1, now = (1 - z / 2) / (1 + z / 2);
        for (int i = 1; i < n; ++i) std::swap(before, now), now = (4 * before - now) / (3 + 2 * z);
        return now;
    });
    for (const double zeta : {1e4, 1e6, 1e7, 1e8, 1e10, 1e14, 1e100, 1e300}) {
        const auto all = advise(DampedSpring<double>(100.0, zeta), zeta / 1e9);
        CAPTURE(zeta);
        CHECK(std::abs(of(all, "implicit Euler").accurate_step / (2 * zeta * euler / 100) - 1) < 1e-3);
        CHECK(std::abs(of(all, "BDF2").accurate_step / (2 * zeta * two_steps / 100) - 1) < 1e-3);
        CHECK(of(all, "implicit Euler").right);
        CHECK(of(all, "BDF2").right);
        REQUIRE(cheapest(all, zeta / 1e9) != nullptr);
    }
    const DampedSpring<double> spring(100.0, 1e8);
    const double h = 1.0 / 60, time = 2000;
    const auto measure = [&](const auto& method) {
        const double x = run(method, spring, State<double>{0, 1, 0}, h, 120'000).x;
        CHECK(std::abs(std::log(x) / (-time * 100 / 2e8) - 1) < 1e-3);
    };
    measure(implicit_euler);
    measure(bdf2);
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

// The slow part is right at steps of hours; the fast one is multiplied by nearly −1 and shakes for ages.
TEST_CASE("a step at which a fast decay rings is not right, and the advice says so", "[library][I13][I15]") {
    const auto very = advise(DampedSpring<double>(10.0, 1e6), 1.0 / 60);
    CHECK(of(very, "implicit midpoint").verdict == Verdict::stable);
    CHECK(std::abs(of(very, "implicit midpoint").ringing + 1) < 1e-4);
    CHECK(of(very, "implicit midpoint").accurate_step < 4e-7);  // R(z) = −1/2 at z = −6, of 2e7 a second
    CHECK(of(very, "implicit midpoint").accurate_step > 2e-7);
    CHECK(of(very, "implicit midpoint").reason == "stable, but rings: a step multiplies the fast part by nearly −1");
    CHECK(cheapest(very)->method != "implicit midpoint");

    const auto some = advise(DampedSpring<double>(5.0, 20.0), 1.0 / 60);
    CHECK(of(some, "implicit midpoint").ringing == 0);                              // −0.25: over in a few steps
    CHECK(std::abs(of(some, "implicit midpoint").accurate_step - 0.03002) < 1e-5);  // 6 over 199.87
    CHECK(of(advise(DampedSpring<double>(5.0, 20.0), 2.74), "implicit midpoint").reason ==
          "stable, but rings: a step multiplies the fast part by −0.993");
    const Advice* best = cheapest(some, 1.0 / 60);
    CHECK(best_step(*best, 1.0 / 60) <= 1.0 / 60);
    CHECK(std::abs(best_cost(*best, 1.0 / 60) / 120 - 1) < 1e-9);
    for (const char* name : {"implicit Euler", "BDF2"}) {
        CHECK(of(very, name).ringing == 0);
        CHECK(of(some, name).ringing == 0);
    }
}

// The advice's word against the run: a kick, and how often the velocity turns its sign. A multiplier below
// −1/2 that is real turns it at every step, a complex one at two of three; the true motion after a kick
// turns once where it swings no more.
TEST_CASE("what is said to ring turns its sign step by step, and an implicit Euler never does", "[library][I13]") {
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
        if constexpr (!std::remove_cvref_t<decltype(method)>::takes_damping)
            return;
        else {
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
                } else {
                    CHECK(advice.reason.find("rings") == std::string::npos);
                }
                if constexpr (std::is_same_v<std::remove_cvref_t<decltype(method)>, ImplicitEuler>)
                    if (spring.zeta > 1) CHECK(turns(method, spring, h) <= 1);
            }
            methods += any;
        }
    };
    for_each_method(measure);
    measure(semi_implicit_euler_new_damping);
    measure(constant_acceleration);
    CHECK(ringing > 20);
    CHECK(methods >= 4);  // explicit Euler, both semi-implicit ones, implicit midpoint, the constant force
}

TEST_CASE("no step longer than the asked one is recommended, and its cost is that of the step", "[library][I13][I15]") {
    for (const double zeta : {0.0, 0.2, 3.0, 50.0})
        for (const double h : {1e-4, 0.01, 0.1, 3.0}) {
            const auto all = advise(DampedSpring<double>(10.0, zeta), h);
            const Advice* best = cheapest(all, h);
            REQUIRE(best != nullptr);
            CHECK(best_step(*best, h) <= h);
            CHECK(best_step(*best, h) <= best->accurate_step);
            for (const Advice& other : all)
                if (other.accurate_cost > 0) CHECK(best_cost(*best, h) <= best_cost(other, h) * (1 + 1e-9));
        }
    // At a short step those that cost one evaluation are the cheapest, and equally dear.
    CHECK(cheapest(advise(DampedSpring<double>(10.0, 0.0), 0.001), 0.001)->cost < 1001);
}
