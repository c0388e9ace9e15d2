// The claims of chapter NEW_NUMBER.

#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/models/projectile.hpp>

using namespace timestep;

// FILL IN: what your chapter claims and no study checks. A test of a claim of the talks has that claim as a tag, as in
// [N12].
TEST_CASE("NEW_NAME: explicit Euler's error is half a step times the velocity gained", "[chNEW_NUMBER]") {
    for (const double gravity : {-9.81, -1.62, 3.0})
        for (const int steps : {1, 7, 100}) {
            const double h = 2.0 / steps;  // two seconds
            const Projectile ball(gravity);
            const State start{0, 1.0, 4.0};
            State state = start;
            for (int n = 0; n < steps; ++n) state = explicit_euler.step(ball, state, h);
            // x₀ + v₀ t + ½ g t (t − h), where the parabola has ½ g t². Positions and velocities are
            // below 40: each of 100 steps rounds by less than 1e-14.
            const double error = state.x - ball.exact(start, 2).x;
            CHECK(std::fabs(error + h / 2 * (2 * gravity)) < 1e-12);
        }
}
