// A rope of links: what it refuses, how it hangs, how stiff it is.
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <Eigen/Core>

#include <cmath>

#include <timestep/rope.hpp>

using namespace timestep;
using Catch::Matchers::Message;
using Eigen::Vector2d;

namespace {

const Projectile gravity(Vector2d(0, -9.81));

// After 7200 sweeps the slowest motion of 20 links has less than 1e-8 of the whole left, measured:
// it fades sweep by sweep, in however few steps.
double stretch_at_rest(double h, std::size_t links) {
    Rope rope(Vector2d(0, 0), Vector2d(0, -1), links, 0.1, gravity);
    for (int n = 0; n < 7200; ++n) rope.step(h, 1);
    return rope.stretch();
}

}  // namespace

TEST_CASE("a rope refuses links that make no sense", "[library]") {
    CHECK_THROWS_MATCHES(Rope(Vector2d(0, 0), Vector2d(0, -1), 0, 0.1, gravity), std::invalid_argument,
                         Message("links: must be one or more"));
    CHECK_THROWS_MATCHES(Rope(Vector2d(0, 0), Vector2d(0, -1), 3, -0.1, gravity), std::invalid_argument,
                         Message("link = -0.1: must be finite and greater than zero"));
    CHECK_THROWS_MATCHES(Rope(Vector2d(0, 0), Vector2d(0, 0), 3, 0.1, gravity), std::invalid_argument,
                         Message("length of the direction = 0: must be finite and greater than zero"));
    CHECK_THROWS_MATCHES(Rope(Vector2d(NAN, 0), Vector2d(0, -1), 3, 0.1, gravity), std::invalid_argument,
                         Message("top: must be a finite place"));
    Rope rope(Vector2d(0, 0), Vector2d(0, -1), 3, 0.1, gravity);
    CHECK_THROWS_MATCHES(rope.step(-1, 1), std::invalid_argument,
                         Message("step = -1: must be finite and greater than zero"));
    CHECK_THROWS_MATCHES(rope.step(0.1, -3), std::invalid_argument,
                         Message("sweeps = -3: must be finite and zero or more"));
}

// From rest the step moves the lower point by h²a = 0.5, exactly onto the point that is held.
TEST_CASE("two points of a rope in one place stay there", "[library]") {
    Rope rope(Vector2d(0, 0), Vector2d(0, -1), 1, 0.5, Projectile(Vector2d(0, 0.5)));
    rope.step(1, 3);
    CHECK(rope.points()[1].x == Vector2d(0, 0));
    rope.step(1, 3);  // they part again: 2·0 + 0.5 + 0.5, and the link pulls back to 0.5
    CHECK(rope.points()[1].x == Vector2d(0, 0.5));
}

// A step lowers every point by d = h²g, and the sweep, from the top, must lift it by as much. Link
// i meets an excess E_i and moves its ends by E_i/2 each. Point n is lifted by E_n/2 = d; point i
// by (E_i − E_{i+1})/2 = d: so E_i = 2d (n − i + 1). What the next link's turn leaves of link i is
// E_{i+1}/2 = d (n − i): on the mean d (n − 1)/2.
TEST_CASE("one iteration a step hangs (n - 1) h^2 g / 2 too long a link, on the mean", "[library][ch4]") {
    for (const std::size_t links : {5u, 10u, 20u}) {
        const double h = 1.0 / 120;
        const double expected = double(links - 1) / 2 * h * h * 9.81 / 0.1;
        CHECK(std::fabs(stretch_at_rest(h, links) / expected - 1) < 1e-7);
    }
}
