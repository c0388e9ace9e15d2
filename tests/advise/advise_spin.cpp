// N51, I13: the advice on a spinning body, against the steps themselves.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <random>

#include "advise_body.hpp"

#include "random_inertia.hpp"

using namespace timestep;

namespace {

template <class Solver>
double energy_gain(const Solver&, const PrincipalInertia<double>& inertia, const Vector3<double>& omega, double h) {
    return body_solver(Solver::name).gain(inertia, Vector3<double>(h * omega));
}

BodyAdvice judge(const char* name, const PrincipalInertia<double>& inertia, double spin, double h) {
    return body_solver(name).judge(inertia, spin, h, true);
}

}  // namespace

// The formula of the longest step came from a search, so it is held to another: darts close to the middle
// axis, where the first gains are needles.
TEST_CASE("one iteration gains from h|omega| = sqrt(I1 I3)/(I3 - I1) on", "[library][N51][I13]") {
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
        const double limit = longest_safe_step(body, 1);
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

TEST_CASE("a solver that is said to add energy does so at the worst spin that it names", "[library][N51][I13]") {
    const PrincipalInertia<double> nearly_round(1, 1.0000001, 1.9);
    const BodyAdvice one = judge(ImplicitGyroscopic::name, nearly_round, 5, 1);  // at most 1e-12 in any direction
    CHECK(one.adds == AddsEnergy::too_close_to_call);
    CHECK(one.longest_step < 0.5);
    CHECK(judge(ExplicitGyroscopic::name, nearly_round, 5, 1).adds == AddsEnergy::one_step_can);

    std::mt19937_64 numbers(13);
    std::uniform_real_distribution<double> even;
    for (int n = 0; n < 60; ++n) {
        const double apart = std::pow(10, -9 * even(numbers));
        const PrincipalInertia<double> body(1, 1 + 0.5 * apart, 1.9);
        const double size = std::pow(10, -8 + 10 * even(numbers));
        for_each_gyroscopic([&](const auto& solver) {
            const BodyAdvice advice = judge(solver.name, body, size, 1);
            CAPTURE(advice.method, apart, size, advice.worst_gain - 1, advice.reason);
            if (advice.adds != AddsEnergy::one_step_can) return;
            CHECK(advice.worst_gain > 1 + 1e-12);
            CHECK(std::abs(advice.worst_spin.norm() / size - 1) < 1e-9);
            CHECK(energy_gain(solver, body, advice.worst_spin, 1.0) > 1 + 1e-12);
        });
    }
}

// Beside the direction with u = w, v = 1 (see unbounded_step) the determinant is as small as one likes. The
// order of the moments decides which of its mirror images that is.
TEST_CASE("one iteration's gain has no bound from where its determinant can vanish", "[library][N51][I13]") {
    RandomInertia random(14);
    for (int n = 0; n < 40; ++n) {
        const auto body = random.inertia<double>(30);
        const Vector3<double>& a = body.ratio;
        int least, most;
        body.moments.minCoeff(&least), body.moments.maxCoeff(&most);
        const int middle = 3 - least - most;
        const double from = unbounded_step(body, 1);
        if (!(from < 100)) continue;
        CAPTURE(body.moments.transpose(), from);
        CHECK(from >= 2 * longest_safe_step(body, 1) * (1 - 1e-12));
        CHECK(std::isfinite(judge(implicit_gyroscopic.name, body, 1, 0.999 * from).worst_gain));
        const auto above = judge(implicit_gyroscopic.name, body, 1, 1.001 * from);
        CHECK(std::isinf(above.worst_gain));
        CHECK(above.adds == AddsEnergy::one_step_can);

        const auto gain_beside = [&](double beside) {
            Vector3<double> omega;
            omega[middle] = 1 / std::sqrt(a[least] * a[most]);
            omega[least] = 0.1 / std::sqrt(-a[middle] * a[most]);
            omega[most] = (0.1 + beside) / std::sqrt(-a[middle] * a[least]);
            if (a.prod() > 0) omega = -omega;
            return energy_gain(implicit_gyroscopic, body, omega, 1.0);
        };
        CHECK(gain_beside(1e-3) > 50 * gain_beside(1e-2));
        CHECK(gain_beside(1e-5) > 5000 * gain_beside(1e-3));
        double darts = 0;  // below, the determinant is at least (1 − v)²
        for (int i = 0; i < 4000; ++i)
            darts = std::max(darts, energy_gain(implicit_gyroscopic, body, random.direction<double>(), 0.9 * from));
        CHECK(darts < 1e9);
    }
}
