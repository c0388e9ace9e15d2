// What a scene leaves out: claims of chapter 6.
#include <catch2/catch_test_macros.hpp>

#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "chapters/06_stability/study/mixed.hpp"

using namespace timestep;

namespace {

const BodyScene debris{Weight(9.81), Gyroscopic(passive_gyroscopic)};

// A hundred of each kind, taking turns.
template <class Crowd>
Crowd hundred_of_each() {
    Crowd crowd;
    for (int i = 0; i < 100; ++i) {
        mixed::add_ball(crowd, i);
        mixed::add_capsule(crowd, i);
        mixed::add_box(crowd, i);
    }
    return crowd;
}

template <class Kind>
void same_bits_alone(const mixed::Sorted& start, const mixed::Sorted& end, int steps) {
    for (std::size_t i = 0; i < start.of<Kind>().size(); ++i) {
        BodyState<double> m = start.of<Kind>()[i].state;
        for (int n = 0; n < steps; ++n) debris.step(start.of<Kind>()[i].body, m, 0.01);
        const BodyState<double>& other = end.of<Kind>()[i].state;
        REQUIRE(m.x == other.x);
        REQUIRE(m.v == other.v);
        REQUIRE(m.turning.omega == other.turning.omega);
        REQUIRE(m.turning.q.coeffs() == other.turning.q.coeffs());
    }
}

}  // namespace

TEST_CASE("a crowd sorted by kind moves as its bodies do one by one, to the last bit", "[ch6]") {
    const auto start = hundred_of_each<mixed::Sorted>();
    auto end = start;
    for (int n = 0; n < 30; ++n) end.step(debris, 0.01);
    same_bits_alone<mixed::Ball>(start, end, 30);
    same_bits_alone<mixed::Capsule>(start, end, 30);
    same_bits_alone<mixed::Box>(start, end, 30);
}

// The scene with a drag of zero computes the term, adds −0 · |v| v = ∓0 to the sum, and ends at the
// same place; the scene without it does not compute it, and is of another type.
TEST_CASE("a term left out is a term of zero, but for its instructions", "[ch6]") {
    const DampedSpring legs(10.0, 0.1);
    const Projectile gravity(-9.81);
    const Scene named(legs, gravity, Drag(0.0));
    const Scene left_out(legs, gravity);
    STATIC_REQUIRE(sizeof(left_out) < sizeof(named));
    const State start{0, 1.0, 0.0};
    CHECK(run(semi_implicit_euler, named, start, 0.01, 500).x ==
          run(semi_implicit_euler, left_out, start, 0.01, 500).x);
}

TEST_CASE("a body's scene holds the terms it names, and nothing else", "[ch6]") {
    STATIC_REQUIRE(sizeof(BodyScene{Weight(9.81)}) == sizeof(double));
    STATIC_REQUIRE(sizeof(BodyScene{Weight(9.81), Ground(0.5)}) == 2 * sizeof(double));
    STATIC_REQUIRE(!decltype(mixed::Ball::inertia)::gyroscopic);
}
