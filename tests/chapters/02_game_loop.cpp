// The claims of chapter 2 about the game loop.

#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/game_loop.hpp>
#include <timestep/state.hpp>

using namespace timestep;

namespace {

template <class Real>
constexpr Real eps = std::numeric_limits<Real>::epsilon();

template <class Real>
bool same(const State<Real>& a, const State<Real>& b) {
    return a.t == b.t && a.x == b.x && a.v == b.v;
}

}  // namespace

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

TEMPLATE_TEST_CASE("what is drawn lies between the last two states", "[I02][ch2]", float, double, long double) {
    const State<TestType> before{1, 2, -3}, now{2, 6, 5};
    CHECK(same(interpolate(before, now, TestType(0)), before));
    CHECK(same(interpolate(before, now, TestType(1)), now));
    CHECK(same(interpolate(before, now, TestType(0.25)), State<TestType>{TestType(1.25), 3, -1}));
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
    GameLoop loop(1.0 / 120, 1000);
    long wanted = 0;
    bool own = true;
    for (const double frame : {1.0 / 144, 0.1, 1.9, 0.0, 1.0 / 59, 1.0 / 24, 2.0})
        loop.frame(frame, [&](double h) {
            own = own && loop.steps() == wanted && loop.time() == double(wanted) * h;
            ++wanted;
        });
    CHECK(own);
    CHECK(loop.steps() == wanted);
    CHECK(wanted > 400);
}
