// I13: the advice on a damper alone, and on a spring whose damper hides its fast decay, against runs.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <timestep/run.hpp>

#include "advice_of.hpp"
#include "method_on_spring.hpp"

using namespace timestep;

namespace {

struct Damper {
    double rate;
    double acceleration(double, double v) const { return -rate * v; }
    double slope_x() const { return 0; }
    double slope_v() const { return -rate; }
};

// The largest error of the velocity after a throw, until 2π over `rate`.
template <class Method, class Model>
double thrown(const Method& method, const Model& model, double rate, double h) {
    const double fit = std::floor(2 * std::numbers::pi / (rate * h) * (1 + 1e-12));
    double most = 0;
    long n = 0;
    run(method, model, State<double>{0, 0, 1}, h, fit < 3 ? 8L : long(fit), [&](const auto& s) {
        double truth = std::exp(-rate * h * double(n));
        if constexpr (requires { model.zeta; }) truth = model.exact(State<double>{0, 0, 1}, h * double(n)).v;
        most = std::max(most, std::abs(s.v - truth)), ++n;
    });
    return most;
}

}  // namespace

TEST_CASE("of a damper alone every verdict and every error is that of a run", "[library][I13]") {
    for (const double z : {1e-3, 0.1, 0.5, 1.0, 1.9, 2.1, 2.7, 2.9, 10.0}) {
        const double rate = 60, h = z / rate;
        const auto all = advise_damper(rate, h);
        for_each_damped([&](const auto& method) {
            const Advice& advice = of(all, method.name);
            CAPTURE(z, method.name, advice.reason);
            const double seen = thrown(method, Damper{rate}, rate, h);
            // Long decays are sampled; roundoff of 6,283 steps.
            CHECK(std::abs(advice.position_error - seen) <= 1e-4 * seen + 1e-11);
            const double end = run(method, Damper{rate}, State<double>{0, 0, 1}, h, 400L).v;
            CHECK((advice.verdict == Verdict::grows) == !(std::abs(end) <= 1));
            CHECK(advice.right == (advice.verdict == Verdict::stable && advice.ringing == 0 && seen <= 0.01));
            if (advice.accurate_step > 0) {
                CHECK(thrown(method, Damper{rate}, rate, 0.9999 * advice.accurate_step) <= 0.01);
                CHECK(thrown(method, Damper{rate}, rate, 1.03 * advice.accurate_step) > 0.01);
            }
        });
        CHECK(of(all, "Verlet").verdict == Verdict::refused);
    }
}

TEST_CASE("a damper alone goes down the list, or to the least cost that reaches the accuracy", "[library][I13]") {
    const auto answer = [](double z, const Goal& goal) {
        return recommend_damper(60, z / 60, goal, advise_damper(60, z / 60, goal.accuracy));
    };
    CHECK(answer(1, {}).method == "semi-implicit Euler, new damping");
    CHECK(answer(2.1, {}).method == "implicit Euler");
    for (const double z : {0.01, 0.3, 1.0, 5.0, 100.0}) {
        const Recommendation made = answer(z, {.precise = true});
        CAPTURE(z, made.method, made.substeps);
        CHECK(made.position_error <= 0.01);
    }
    CHECK_THROWS_AS(advise_damper(0, 0.01), std::invalid_argument);
    CHECK_THROWS_AS(advise_damper(60, NAN), std::invalid_argument);
    CHECK_THROWS_AS(advise_damper(1e-10, 1e-10), std::invalid_argument);
}

// 1e-9 N/m and 60 N s/m on a kilogram: explicit Euler stops the body in one step, the true motion keeps 37 % of its
// speed.
TEST_CASE("a spring that hardly pulls does not hide what its damper does to a throw", "[library][I13]") {
    for (const double stiffness : {1e-9, 1.0}) {
        const auto spring = DampedSpring<double>::from_stiffness(stiffness, 60, 1);
        const double h = 1.0 / 60, fast = spring.omega * detail::fast_decay(spring.zeta);
        const auto all = advise(spring, h);
        CAPTURE(stiffness);
        CHECK_FALSE(of(all, "explicit Euler").right);
        CHECK(of(all, "explicit Euler").position_error > 0.3);
        CHECK(cheapest(all, h)->method != "explicit Euler");
        for_each_damped([&](const auto& method) {
            CAPTURE(method.name);
            const double seen = thrown(method, spring, fast, h);
            CHECK(of(all, method.name).position_error >= 0.999 * seen);
            if (of(all, method.name).right) CHECK(seen <= 0.01);
        });
    }
    // Over within three steps a throw is not looked at: the stiff pull of a controller.
    CHECK_FALSE(thrown_counts(20, 5.0 / 60));
    CHECK(thrown_counts(20, 5.0 / 240));
    CHECK_FALSE(thrown_counts(5, 5.0 / 240));  // its positions show both decays
}
