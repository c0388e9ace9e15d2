// The claims of chapter 4 about Verlet's positions and its forms. (Chapter 6's study measures their orders.)

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>

using namespace timestep;

TEST_CASE("symplectic Euler moves the position with the velocity of the same step", "[I06][ch4]") {
    const Pendulum pendulum(1.5);
    State before{0, 1.0, 0.3};
    for (int i = 0; i < 100; ++i) {
        const State after = semi_implicit_euler.step(pendulum, before, 0.1);
        CHECK(after.x == before.x + 0.1 * after.v);
        before = after;
    }
}

TEST_CASE("one step of Verlet is what hand arithmetic gives", "[I07][ch4]") {
    // ω = 2, h = 1/4, from 1 and 1/2: a = −2, x = 2/2 − 1 − 2/16. No rounding.
    const Spring spring(2.0);
    const State next = verlet.step(spring, State{0, 1.0, 0.0}, State{0.25, 0.5, 0.0}, 0.25);
    CHECK(next.t == 0.5);
    CHECK(next.x == -0.125);
    CHECK(next.v == -0.625 / 0.25 - 0.25);
    // And the first step from x = 1, v = 2: 1 + 1/2 − 4/32.
    CHECK(verlet.start(spring, State{0, 1.0, 2.0}, 0.25).x == 1.375);
}

TEST_CASE("Verlet never looks at the velocity", "[I08][ch4]") {
    const Pendulum pendulum(2.0);
    const State a{0, 0.5, 0.0}, b{0.1, 0.6, 0.0};
    const State wild_a{0, 0.5, 1e9}, wild_b{0.1, 0.6, -std::numeric_limits<double>::quiet_NaN()};
    CHECK(verlet.step(pendulum, a, b, 0.1).x == verlet.step(pendulum, wild_a, wild_b, 0.1).x);
    CHECK(verlet.corrected_step(pendulum, a, b, 0.1, 0.2).x ==
          verlet.corrected_step(pendulum, wild_a, wild_b, 0.1, 0.2).x);
    // A damper does not compile: tests/compile_fail.
    CHECK(PositionForce<Spring<double>, double>);
    CHECK(PositionForce<Projectile<double>, double>);
    CHECK_FALSE(PositionForce<DampedSpring<double>, double>);
}

// What exercise 4.2 tells afterwards.
TEST_CASE("put on the floor with \"before\" left alone, a ball stays there", "[ch4]") {
    const Projectile gravity(-9.81);
    const double h = 1.0 / 60;
    for (const double height : {0.3, 1.0, 2.7}) {
        State before{0, height, 0.0}, now = verlet.start(gravity, before, h);
        bool touched = false;
        for (int n = 0; n < 600; ++n) {
            const double last = now.x;
            State next = verlet.step(gravity, before, now, h);
            before = now;
            now = next;
            if (now.x < 0) touched = true, now.x = 0;
            if (touched) CHECK(now.x <= last);
        }
        CHECK(touched);
        CHECK(now.x == 0);
        CHECK(before.x == 0);
    }
}

TEST_CASE("with equal steps both repairs are plain Verlet", "[I10][ch4]") {
    // h = 1/8, ω = 2 and positions of few digits: no rounding.
    const Spring spring(2.0);
    const State s0{0, 1.0, 0.0}, s1{0.125, 0.75, 0.0};
    const double x2 = verlet.step(spring, s0, s1, 0.125).x;
    CHECK(verlet.scaled_step(spring, s0, s1, 0.125, 0.125).x == x2);
    CHECK(verlet.corrected_step(spring, s0, s1, 0.125, 0.125).x == x2);
}
