// I13, I15: which steps the advice calls right, against runs with them.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <random>

#include <timestep/advise.hpp>
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
    for (const char* name : {"explicit Euler", "implicit Euler", "semi-implicit Euler", "Newton"})
        CHECK(std::abs(order_of(name) - 1) < 0.05);
    for (const char* name : {"midpoint", "Heun", "implicit midpoint", "BDF2"})
        CHECK(std::abs(order_of(name) - 2) < 0.05);
    CHECK(std::abs(order_of("Runge-Kutta 4") - 4) < 0.1);
    REQUIRE(cheapest(fine) != nullptr);
    CHECK(cheapest(fine)->method == "Runge-Kutta 4");
}

// There the two exponents of the motion are one, and a change of the spring by ε splits them by √ε: a
// method is not wrong by that.
TEST_CASE("at ζ = 1 the step for an accuracy is about as long as beside it", "[library][I13][I15]") {
    std::vector<Advice> before;
    for (const double zeta : {0.99, 0.9999, 1.0, 1.0001, 1.01}) {
        const auto all = advise(DampedSpring<double>(10.0, zeta), 0.01, 0.01);
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].verdict == Verdict::refused) continue;
            CAPTURE(zeta, all[i].method, all[i].accurate_step);
            CHECK(all[i].accurate_step > 0);
            if (!before.empty())
                CHECK(std::abs(std::log(all[i].accurate_step / before[i].accurate_step)) < 0.2);
        }
        before = all;
    }
}

namespace {

// How far a run's positions leave the exact motion through two of them, so that where a method has its
// velocity does not count. A spring that is off by 1 % is off by 4 % in its phase after 4 radians.
template <class Method>
double off(const Method& method, const DampedSpring<double>& spring, double h) {
    const auto exact = [&](double x, double v, double t) {
        return spring.exact(State<double>{0, x, v}, t).x;
    };
    std::vector<double> x;
    const auto steps = std::max(3L, std::lround(4 / (spring.omega * h)));
    run(method, spring, State<double>{0, 1, 0.3 * spring.omega}, h, steps,
        [&](const State<double>& s) { x.push_back(s.x); });
    const double quarter = h * static_cast<double>(x.size() / 4);
    const double v = (x[x.size() / 4] - exact(1, 0, quarter)) / exact(0, 1, quarter);
    double most = 0;
    for (std::size_t n = 0; n < x.size(); ++n)
        most = std::max(most, std::abs(x[n] - exact(1, v, h * static_cast<double>(n))));
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

// Every method that steps a damper and has one state.
template <class Visit>
void for_each_damped(const Visit& visit) {
    for_each_method([&](const auto& method) {
        if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(method)>, Bdf2>) visit(method);
    });
    visit(semi_implicit_euler_new_damping);
    visit(newton);
}

}  // namespace

TEST_CASE("a step that is right to 1 % shows a motion that is", "[library][I13][I15]") {
    for (const double zeta : {0.1, 0.5, 0.9, 0.99, 1.0, 1.01, 1.1}) {
        const DampedSpring<double> spring(1.0, zeta);
        for_each_damped([&](const auto& method) {
            const double h = of(advise(spring, 0.01, 0.01), method.name).accurate_step;
            CAPTURE(zeta, method.name, h);
            REQUIRE(h > 0);
            CHECK(off(method, spring, h) < 0.04);
        });
    }
}

// Of these steps some lie far beyond the first stretch of right ones.
TEST_CASE("an asked step is right when its own error is small, and then a run is", "[library][I13][I15]") {
    const auto island = advise(DampedSpring<double>(100.0, 0.1), 0.0111);
    const Advice found = of(island, "semi-implicit Euler, new damping");
    CHECK(found.right);
    CHECK(found.accurate_step < 0.003);
    CHECK(best_step(found, 0.0111) == 0.0111);
    CHECK(best_step(found, 0.011) == found.accurate_step);
    CHECK(cheapest(island, 0.0111)->method == found.method);
    CHECK(std::abs(best_cost(found, 0.0111) / found.cost - 1) < 1e-12);

    std::mt19937_64 numbers(12);
    std::uniform_real_distribution<double> even;
    long right = 0, beyond = 0;
    for_each_damped([&](const auto& method) {
        for (int i = 0; i < 1000; ++i) {
            const DampedSpring<double> spring(1.0, 0.05 * std::pow(100, even(numbers)));
            const double h = 0.01 * std::pow(1000, even(numbers));
            const Advice advice = detail::advise(method, spring, h, 0.01);
            CAPTURE(method.name, spring.zeta, h, advice.rate_error);
            if (advice.accurate_step > 1.001 * h) CHECK(advice.right);
            if (!advice.right) continue;
            CHECK(advice.verdict == Verdict::stable);
            CHECK(advice.rate_error <= 0.01);
            CHECK((spring.zeta < 1.1 ? off(method, spring, h) : slow_off(method, spring, h)) < 0.04);
            ++right, beyond += h > advice.accurate_step;
        }
    });
    CHECK(right > 1000);
    CHECK(beyond > 0);
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
    for (const char* name : {"explicit Euler", "Newton"}) {
        CHECK(of(loose, name).right);
        CHECK(of(loose, name).accurate_step > 1.9e-5);
    }
    const auto close = advise(DampedSpring<double>(100.0, 0.001), 1.9999e-5, 0.05);
    CHECK_FALSE(of(close, "explicit Euler").right);  // too close to call
    CHECK(of(close, "explicit Euler").accurate_step < 1.9981e-5);
}

// The slow decay's rate is ω/(2ζ). With z = s/(2ζ) implicit Euler's error is 1 − ln(1 + z)/z.
TEST_CASE("however hard the damper, the methods without a limit are right up to the same share", "[library][I13]") {
    const double z = 0.020270;  // 1 − ln(1 + z)/z is 1 %
    for (const double zeta : {1e4, 1e6, 1e7, 1e8, 1e10, 1e14, 1e100, 1e300}) {
        const auto all = advise(DampedSpring<double>(100.0, zeta), zeta / 1e9);
        CAPTURE(zeta);
        CHECK(std::abs(of(all, "implicit Euler").accurate_step / (2 * zeta * z / 100) - 1) < 1e-3);
        CHECK(std::abs(of(all, "BDF2").accurate_step / (2 * zeta * 0.16046 / 100) - 1) < 1e-3);
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
    CHECK(of(some, "implicit midpoint").ringing == 0);  // −0.25: over in a few steps
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
        if constexpr (!detail::takes_damping<std::remove_cvref_t<decltype(method)>>) return;
        else {
            bool any = false;
            for (int i = 0; i < 500; ++i) {
                const DampedSpring<double> spring(1.0, 0.6 * std::pow(200, even(numbers)));
                const double h = std::pow(10, -3 + 6 * even(numbers));
                const Advice advice = detail::advise(method, spring, h, 0.01);
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
    measure(newton);
    CHECK(ringing > 60);
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
