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
#include <timestep/scene.hpp>

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
