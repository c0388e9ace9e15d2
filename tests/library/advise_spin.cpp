// N51, I13: the advice on a spinning body, against the steps themselves.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <random>

#include <timestep/advise_spin.hpp>

#include "random_inertia.hpp"

using namespace timestep;

namespace {

SpinAdvice of(const std::vector<SpinAdvice>& all, const std::string& method) {
    for (const SpinAdvice& advice : all)
        if (advice.method == method) return advice;
    FAIL("no advice on " << method);
    return all.front();
}


}  // namespace

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
