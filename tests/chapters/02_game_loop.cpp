// The claims of chapter 2 about the game loop.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <timestep/game_loop.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/scene.hpp>
#include <timestep/stability.hpp>

using namespace timestep;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

// Frame times that add up to about four seconds: steady ones, ones as they come, and one long
// hitch.
template <class Real>
std::vector<std::vector<Real>> frame_rates() {
    std::vector<std::vector<Real>> all;
    for (const int rate : {144, 60, 59, 30, 24}) all.push_back(std::vector<Real>(4 * rate, Real(1) / rate));
    for (const unsigned seed : {1u, 2u, 3u}) {
        std::mt19937 random(seed);
        std::vector<Real> frames;
        for (Real t = 0; t < 4; t += frames.back())
            frames.push_back(Real(0.001) + Real(0.08) * (random() / Real(4294967296.0)));
        all.push_back(frames);
    }
    all.push_back({Real(0.1), Real(1.9), Real(0), Real(0), Real(2)});
    return all;
}

template <class Real, class Method>
std::vector<State<Real>> states(const Method& method, const std::vector<Real>& frames) {
    const Scene character{DampedSpring(Real(8), Real(0.1)), Projectile(Real(-9.81))};
    GameLoop<Real> loop(Real(1) / 60, 1000);
    State<Real> state{0, 0, -3};
    std::vector<State<Real>> result;
    for (const Real passed : frames)
        loop.frame(passed, [&](Real h) {
            state = method.step(character, state, h);
            result.push_back(state);
        });
    CHECK(static_cast<long>(result.size()) == loop.steps());
    return result;
}

template <class Real>
bool same(const State<Real>& a, const State<Real>& b) {
    return a.t == b.t && a.x == b.x && a.v == b.v;
}

}  // namespace

TEMPLATE_TEST_CASE("a fixed step finds the same states at any frame rate, bit for bit", "[I02][ch2]", float, double,
                   long double) {
    const auto compare = [](const auto& method) {
        const auto rates = frame_rates<TestType>();
        const auto first = states(method, rates[0]);
        for (const auto& frames : rates) {
            const auto other = states(method, frames);
            // Four seconds are 240 steps; roundoff in the frame times decides whether the last one
            // comes now or with the next frame, and a frame of the last kind adds up to 0.08 s.
            CHECK(other.size() >= 239);
            CHECK(other.size() <= 245);
            const std::size_t n = std::min(first.size(), other.size());
            for (std::size_t i = 0; i < n; ++i)
                if (!same(first[i], other[i])) {
                    FAIL_CHECK("step " << i << " differs");
                    break;
                }
        }
    };
    compare(explicit_euler);
    compare(semi_implicit_euler);
    compare(runge_kutta_4);
}

TEST_CASE("with the frame's time as the step, the frame rate decides the motion", "[I02][ch2]") {
    const Scene character{DampedSpring(8.0, 0.1), Projectile(-9.81)};
    const auto swing_after = [&](int rate, int seconds) {
        State<double> state{0, 0, -3};
        for (int i = 0; i < seconds * rate; ++i) state = explicit_euler.step(character, state, 1.0 / rate);
        return std::hypot(state.x + 9.81 / 64, state.v / 8);
    };
    // A step multiplies the swing by √(1 − 2ζωh + (ωh)²): below one for h < 2ζ/ω = 1/40 s only.
    CHECK(swing_after(144, 3) < 0.5 * swing_after(144, 1));
    CHECK(swing_after(60, 3) < swing_after(60, 1));
    CHECK(swing_after(30, 3) > swing_after(30, 1));
    CHECK(swing_after(24, 3) > 3 * swing_after(60, 3));
}

TEST_CASE("frames that take turns blow up what each frame rate alone keeps", "[I02][ch2]") {
    const double h = 1.0 / 60;
    // Two steps: determinant 1, trace 2 − (a + b)² + a²b² with a = ωh, b = 2ωh.
    const auto radius = [&](double omega, double h1, double h2) {
        const auto one = step_matrix(semi_implicit_euler, Spring(omega), h1);
        const auto two = step_matrix(semi_implicit_euler, Spring(omega), h2);
        const StepMatrix<double> both{two.xx * one.xx + two.xv * one.vx, two.xx * one.xv + two.xv * one.vv,
                                      two.vx * one.xx + two.vv * one.vx, two.vx * one.xv + two.vv * one.vv};
        const double a = omega * h1, b = omega * h2;
        CHECK(std::fabs(both.trace() - (2 - (a + b) * (a + b) + a * a * b * b)) < 100 * eps<double>);
        return spectral_radius(both);
    };
    // |λ| = 1 up to the root of roundoff, as the two eigenvalues are conjugate.
    CHECK(std::fabs(radius(50, h, h) - 1) < 1e-7);
    CHECK(std::fabs(radius(50, 2 * h, 2 * h) - 1) < 1e-7);
    CHECK(radius(50, h, 2 * h) > 1.5);
    // The band of ωh in which taking turns is fatal: 4u² − 9u + 4 < 0 for u = (ωh)².
    const double low = std::sqrt((9 - std::sqrt(17.0)) / 8), high = std::sqrt((9 + std::sqrt(17.0)) / 8);
    CHECK(std::fabs(radius(0.999 * low / h, h, 2 * h) - 1) < 1e-7);
    CHECK(radius(1.001 * low / h, h, 2 * h) > 1.01);
    CHECK(low * 60 < 50);
    CHECK(high > 1);  // so it lasts up to the limit of the longer frame, ω · 2h = 2
}

TEMPLATE_TEST_CASE("the cap drops what cannot be paid, and nothing else", "[I02][ch2]", float, double, long double) {
    const TestType h = TestType(1) / 60;
    GameLoop<TestType> loop(h, 5);
    long calls = 0;
    const auto count = [&](TestType step) {
        CHECK(step == h);
        ++calls;
    };
    CHECK(loop.frame(TestType(10), count) == 5);
    CHECK(calls == 5);
    CHECK(loop.alpha() >= 0);
    CHECK(loop.alpha() < 1);
    // Simulated, dropped and still owed make up the ten seconds. The sum is rounded by ε · 10/2 a
    // handful of times.
    const TestType total = loop.time() + loop.dropped() + loop.alpha() * h;
    CHECK(std::fabs(total - 10) <= 40 * eps<TestType>);
    // The next frame is an ordinary one again.
    CHECK(loop.frame(TestType(2.5) * h, count) <= 3);

    // Five steps are within the cap: nothing is dropped.
    GameLoop<TestType> exact(h, 5);
    CHECK(exact.frame(TestType(5.5) * h, [](TestType) {}) == 5);
    CHECK(exact.dropped() == 0);
}

TEST_CASE("steps dearer than the time they simulate kill a loop without a cap", "[I02][ch2]") {
    const double h = 1.0 / 60, cost = 1.2 * h;
    GameLoop free(h, 1000000), capped(h, 5);
    double a = 3 * h, b = a;
    for (int i = 0; i < 40; ++i) {
        a = cost * static_cast<double>(free.frame(a, [](double) {}));
        b = cost * static_cast<double>(capped.frame(b, [](double) {}));
        CHECK(b <= 5 * cost * (1 + eps<double>));
    }
    CHECK(a > 100 * b);
    CHECK(free.dropped() == 0);
    CHECK(capped.dropped() > 0);

    // Once frames are steady the game's speed is five steps in the time of a frame: 1/1.2. What all
    // frames together have simulated says another thing, as the first ones were shorter.
    const double before = capped.time(), passed = b;
    CHECK(capped.frame(b, [](double) {}) == 5);
    // Two clocks below 4 s, each rounded by half an ε of that: 4 ε over a frame of 0.1 s.
    CHECK(std::fabs((capped.time() - before) / passed - 1 / 1.2) < 40 * eps<double>);
}

TEMPLATE_TEST_CASE("what is drawn lies between the last two states, one step behind the clock", "[I02][ch2]", float,
                   double, long double) {
    const State<TestType> before{1, 2, -3}, now{2, 6, 5};
    CHECK(same(interpolate(before, now, TestType(0)), before));
    CHECK(same(interpolate(before, now, TestType(1)), now));
    CHECK(same(interpolate(before, now, TestType(0.25)), State<TestType>{TestType(1.25), 3, -1}));

    const TestType h = TestType(1) / 64;
    GameLoop<TestType> loop(h, 1000);
    State<TestType> last{-h, 0, 0}, state{0, 0, 0};
    TestType clock = 0;
    std::mt19937 random(7);
    for (int i = 0; i < 200; ++i) {
        const TestType passed = TestType(random() % 64) / 1024;  // exact in binary, and so is h
        clock += passed;
        loop.frame(passed, [&](TestType step) {
            last = state;
            state.t += step;
        });
        CHECK(loop.alpha() >= 0);
        CHECK(loop.alpha() < 1);
        CHECK(interpolate(last, state, loop.alpha()).t == clock - h);
    }
}

TEST_CASE("steps are counted, so the clock does not drift", "[I02][ch2]") {
    const float h = 1.0f / 60;
    GameLoop loop(h, 1000);
    float added = 0;
    for (int i = 0; i < 60 * 60 * 60; ++i) loop.frame(h, [&](float step) { added += step; });
    CHECK(loop.steps() == 60 * 60 * 60);
    // h is rounded by ε/2 of itself, and so is the product: an hour is off by ε of itself.
    CHECK(std::fabs(loop.time() - 3600) <= 3600 * eps<float>);
    CHECK(std::fabs(added - 3600) > 1);
}

TEST_CASE("a game loop refuses what cannot be", "[I02][ch2]") {
    CHECK_THROWS_AS(GameLoop(0.0, 5), std::invalid_argument);
    CHECK_THROWS_AS(GameLoop(-0.1, 5), std::invalid_argument);
    CHECK_THROWS_AS(GameLoop(NAN, 5), std::invalid_argument);
    CHECK_THROWS_AS(GameLoop(0.1, 0), std::invalid_argument);
    GameLoop loop(0.1, 5);
    const auto nothing = [](double) {};
    CHECK_THROWS_AS(loop.frame(-0.1, nothing), std::invalid_argument);
    CHECK_THROWS_AS(loop.frame(NAN, nothing), std::invalid_argument);
    CHECK_THROWS_AS(loop.frame(INFINITY, nothing), std::invalid_argument);
    CHECK(loop.frame(0.25, nothing) == 2);  // a refused frame has left no trace
    CHECK(loop.frame(0, nothing) == 0);
}

// A replay asks the loop for the number of the step that it is about to take.
TEST_CASE("each step sees its own number and time, whatever the frames", "[I02][ch2]") {
    for (const auto& frames : frame_rates<double>()) {
        GameLoop loop(1.0 / 120, 1000);
        long wanted = 0;
        bool own = true;
        for (const double frame : frames)
            loop.frame(frame, [&](double h) {
                own = own && loop.steps() == wanted && loop.time() == double(wanted) * h;
                ++wanted;
            });
        CHECK(own);
        CHECK(loop.steps() == wanted);
    }
}
