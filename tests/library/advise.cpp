// I13: the advice on a spring and on a spinning body, against what the methods really do.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <numeric>

#include <timestep/advise_spin.hpp>
#include <timestep/run.hpp>

#include "random_inertia.hpp"

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

Advice of(const std::vector<Advice>& all, const std::string& method) {
    for (const Advice& advice : all)
        if (advice.method == method) return advice;
    FAIL("no advice on " << method);
    return all.front();
}
SpinAdvice of(const std::vector<SpinAdvice>& all, const std::string& method) {
    for (const SpinAdvice& advice : all)
        if (advice.method == method) return advice;
    FAIL("no advice on " << method);
    return all.front();
}

}  // namespace

// Just below the limit nothing grows, just above it something does; and the whole way below it is
// stable, so that the limit is the first.
TEST_CASE("the formulas for the longest stable step are those of the steps' eigenvalues", "[library][N23][N25][N33][I13]") {
    const auto holds = [](const auto& method) {
        constexpr bool damped = detail::takes_damping<std::remove_cvref_t<decltype(method)>>;
        for (const double zeta : zetas) {
            if (!damped && zeta > 0) continue;
            CAPTURE(method.name, zeta);
            const double limit = stability_limit(method, zeta).value;
            // 1e-14 for roundoff: λ comes from numbers of size one in long double.
            if (std::isinf(limit)) {
                for (double s = 1e-3; s < 1e9; s *= 3) CHECK(growth(method, zeta, s) <= 1 + 1e-14);
            } else if (limit > 0) {
                for (int i = 1; i <= 200; ++i)
                    CHECK(growth(method, zeta, 0.9999 * limit * i / 200) <= 1 + 1e-14);
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

TEST_CASE("no method has an eigenvalue outside the unit disk where its limit is infinite, however stiff", "[library][I13]") {
    for (const double zeta : zetas)
        for (double s = 1; s < 1e12; s *= 10) {
            CHECK(growth(implicit_euler, zeta, s) <= 1 + 1e-14);
            CHECK(growth(implicit_midpoint, zeta, s) <= 1 + 1e-14);
            CHECK(growth(bdf2, zeta, s) <= 1 + 1e-14);
        }
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
    measure(newton);
}

TEST_CASE("the predicted period is what a run's zeros show", "[library][I13]") {
    const Spring<double> spring(30.0);
    const auto all = advise(DampedSpring<double>(30.0, 0.0), 1.0 / 60);
    const auto measure = [&](const auto& method) {
        CAPTURE(method.name);
        double before = 1, first = 0, last = 0;
        int zeros = 0;
        run(method, spring, State<double>{0, 1, 0}, 1.0 / 60, 4000, [&](const State<double>& s) {
            if (before * s.x < 0) {
                const double at = s.t - (1.0 / 60) * s.x / (s.x - before);
                (zeros == 0 ? first : last) = at;
                ++zeros;
            }
            before = s.x;
        });
        const double period = 2 * (last - first) / (zeros - 1);
        const double exact = 2 * 3.141592653589793 / 30;
        // Each end is within a step of a thousand half swings of two or three steps.
        CHECK(std::abs(period / exact - 1 - of(all, method.name).period_error) < 2e-3);
    };
    measure(semi_implicit_euler);
    measure(implicit_midpoint);
    measure(velocity_verlet);
    measure(verlet);
    measure(newton);
    measure(explicit_euler);
}

TEST_CASE("near the boundary the advice says so, and on both sides it is sure", "[library][I13]") {
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

TEST_CASE("Verlet is refused where there is a damper, and advised on where there is none", "[library][I08][I13]") {
    for (const char* name : {"Verlet", "velocity Verlet", "leapfrog"}) {
        CHECK(of(advise(DampedSpring<double>(10.0, 0.1), 0.01), name).verdict == Verdict::refused);
        CHECK(of(advise(DampedSpring<double>(10.0, 0.0), 0.01), name).verdict == Verdict::stable);
    }
}

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

// Compared with the exact motion through the same two positions, so that where a method has its velocity
// does not count. A spring that is off by 1 % is off by 4 % in its phase after 4 radians.
TEST_CASE("a step that is right to 1 % shows a motion that is", "[library][I13][I15]") {
    for (const double zeta : {0.1, 0.5, 0.9, 0.99, 1.0, 1.01, 1.1}) {
        const DampedSpring<double> spring(1.0, zeta);
        const auto measure = [&](const auto& method) {
            const double h = of(advise(spring, 0.01, 0.01), method.name).accurate_step;
            CAPTURE(zeta, method.name, h);
            REQUIRE(h > 0);
            const auto exact = [&](double x, double v, double t) {
                return spring.exact(State<double>{0, x, v}, t).x;
            };
            std::vector<double> x;
            const auto steps = std::max(3L, std::lround(4 / h));
            run(method, spring, State<double>{0, 1, 0.3}, h, steps,
                [&](const State<double>& s) { x.push_back(s.x); });
            const double quarter = h * static_cast<double>(x.size() / 4);
            const double v = (x[x.size() / 4] - exact(1, 0, quarter)) / exact(0, 1, quarter);
            double off = 0;
            for (std::size_t n = 0; n < x.size(); ++n)
                off = std::max(off, std::abs(x[n] - exact(1, v, h * static_cast<double>(n))));
            CHECK(off < 0.04);
        };
        for_each_method([&](const auto& method) {
            if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(method)>, Bdf2>) measure(method);
        });
        measure(semi_implicit_euler_new_damping);
        measure(newton);
    }
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

TEST_CASE("the reason tells a step from the limit, and the limit by one number", "[library][I13]") {
    const auto why = [](double h) { return of(advise(DampedSpring<double>(10.0, 0.0), h), "Verlet").reason; };
    CHECK(why(0.2) == "ωh = 2, the limit itself");
    CHECK(why(0.1) == "ωh = 1 < 2");
    CHECK(why(0.20000001) == "ωh = 2, the limit itself");
    CHECK(why(0.19999) == "ωh = 1.9999 < 2");
}

// Half of the energy a step: far below what the ratio less one can say.
TEST_CASE("the energy that is left is told however little it is", "[library][I13]") {
    const Advice advice = of(advise(DampedSpring<double>(60.0, 0.0), 1.0 / 60), "implicit Euler");
    CHECK(std::abs(advice.energy_ratio / std::pow(2.0, -60) - 1) < 1e-9);  // |λ|² = 1/(1 + (ωh)²)
    CHECK(std::abs(advice.energy_drift - (advice.energy_ratio - 1)) < 1e-15);
}

TEST_CASE("advice on a spring refuses what is no spring and no step", "[library][I13]") {
    const DampedSpring<double> spring(10.0, 0.1);
    CHECK_THROWS_AS(advise(DampedSpring<double>(0.0, 0.1), 0.01), std::invalid_argument);
    CHECK_THROWS_AS(advise(spring, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(advise(spring, -0.01), std::invalid_argument);
    CHECK_THROWS_AS(advise(spring, NAN), std::invalid_argument);
    CHECK_THROWS_AS(advise(DampedSpring<double>(1e100, 0.1), 1e300), std::invalid_argument);
    CHECK_THROWS_AS(advise(DampedSpring<double>(1e-300, 0.1), 1e-300), std::invalid_argument);
    CHECK_THROWS_AS(advise(spring, 0.9e-13), std::invalid_argument);
    CHECK_NOTHROW(advise(spring, 1.1e-13));
    CHECK_THROWS_AS(advise(spring, 0.01, 0.0), std::invalid_argument);
    CHECK_THROWS_AS(advise(spring, 0.01, 1.0), std::invalid_argument);
}

// ---- Spinning bodies -----------------------------------------------------------------------------

TEST_CASE("the search for a gain misses none that darts find", "[library][N51][I13]") {
    RandomInertia random(7);
    std::mt19937_64 numbers(8);
    std::uniform_real_distribution<double> even;
    for (int n = 0; n < 40; ++n) {
        const auto inertia = random.inertia<double>(1000);
        const double size = std::pow(10, -1.5 + 2 * even(numbers));
        const double found = detail::worst_direction(implicit_gyroscopic, inertia, size, 1.0).gain;
        double darts = 0;
        for (int i = 0; i < 4000; ++i)
            darts = std::max(darts, energy_gain(implicit_gyroscopic, inertia, random.direction<double>(), size));
        CAPTURE(inertia.moments.transpose(), size, found - 1, darts - 1);
        CHECK((found > 1 + 1e-12) >= (darts > 1 + 1e-12));
    }
}

// The formula of the longest step came from a search, so it is held to another: darts close to the middle
// axis, where the first gains are needles.
TEST_CASE("one iteration gains from h|ω| = √(I₁I₃)/(I₃ − I₁) on", "[library][N51][I13]") {
    RandomInertia random(9);
    std::mt19937_64 numbers(10);
    std::uniform_real_distribution<double> even(-1, 1);
    for (int n = 0; n < 30; ++n) {
        const auto body = random.inertia<double>(30);
        int least, most;
        body.moments.minCoeff(&least), body.moments.maxCoeff(&most);
        const int middle = 3 - least - most;
        // Where two moments are nearly equal, the gain is too small to be seen.
        const double ratio = body.moments[middle] / body.moments[least];
        if (ratio < 1.1 || body.moments[most] / body.moments[middle] < 1.1) continue;
        const double limit = detail::longest_safe_step(body, 1);
        const auto best_at = [&](double size) {
            double best = 0;
            for (int i = 0; i < 40000; ++i) {
                Vector3<double> way = Vector3<double>::Unit(middle);
                const double wobble = 0.3 * std::pow(even(numbers), 4);
                way[least] = wobble * even(numbers), way[most] = wobble * even(numbers);
                best = std::max(best, energy_gain(implicit_gyroscopic, body, Vector3<double>(way.normalized()), size));
            }
            return best;
        };
        CAPTURE(body.moments.transpose(), limit, best_at(0.998 * limit) - 1, best_at(1.01 * limit) - 1);
        CHECK(best_at(0.998 * limit) <= 1 + 1e-14);
        CHECK(best_at(1.01 * limit) > 1 + 1e-12);
    }
}

TEST_CASE("a spin's advice is what its named direction does", "[library][N51][I13]") {
    const PrincipalInertia<double> plank(0.758, 0.787, 0.0313);
    const double h = 1.0 / 60;
    for_each_gyroscopic([&](const auto& solver) {
        CAPTURE(solver.name);
        const auto advice = of(advise_spin(plank, 60, h), solver.name);
        if (advice.verdict == Verdict::grows) {
            const double gain = energy_gain(solver, plank, advice.worst_spin, h);
            CHECK(gain > 1.01);
            CHECK(std::abs(gain / advice.worst_gain - 1) < 1e-12);
            CHECK(std::abs(advice.worst_spin.norm() - 60) < 1e-9);
        } else {
            CHECK(advice.worst_gain <= 1 + 1e-12);
        }
    });
}

TEST_CASE("equal moments can gain nothing but by what a torque of zero adds", "[library][N41][I13]") {
    for (const auto& advice : advise_spin(PrincipalInertia<double>(2, 2, 2), 100, 0.1)) {
        CAPTURE(advice.method);
        CHECK(advice.verdict == Verdict::stable);
    }
    CHECK(of(advise_spin(PrincipalInertia<double>(1, 1, 0.1), 100, 0.1), "implicit, one iteration").verdict ==
          Verdict::stable);
}

TEST_CASE("advice on a spin refuses what is no spin and no step", "[library][I13]") {
    const PrincipalInertia<double> box(1, 2, 3);
    CHECK_THROWS_AS(advise_spin(box, 0, 0.01), std::invalid_argument);
    CHECK_THROWS_AS(advise_spin(box, INFINITY, 0.01), std::invalid_argument);
    CHECK_THROWS_AS(advise_spin(box, 1, -0.01), std::invalid_argument);
    CHECK_THROWS_AS(advise_spin(box, 1e300, 1e300), std::invalid_argument);
}
