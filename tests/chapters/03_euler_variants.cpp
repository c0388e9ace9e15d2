// The claims of chapter 3.
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

TEST_CASE("explicit Euler multiplies the amplitude by sqrt(1 + (omega h)^2) a step", "[N22]") {
    const Spring spring(10.0);
    const double h = 1.0 / 60;
    const State end = run(explicit_euler, spring, State{0, 1.0, 0.0}, h, 120);
    const double amplitude = std::hypot(end.x, end.v / 10);
    const double predicted = std::pow(1 + 100 * h * h, 60.0);
    // One step rounds x and v by at most 3 ε each: 120 steps, and pow, by 500 ε.
    CHECK(std::fabs(amplitude / predicted - 1) < 500 * 2.3e-16);
}
