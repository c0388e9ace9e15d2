// Chapter 5: the solver's one iteration, and the capsule on the plane.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>
#include <random>

#include "chapters/05_gyroscopic/study/plane_scene.hpp"

using namespace timestep;
using plane::Arms;
using plane::Contacts;
using plane::V;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double h = 1.0 / 60;

template <class Solver, class Inertia, class Look>
plane::BodyState run(const Solver& solver, const plane::Capsule<Inertia>& body, const plane::Ground& ground,
                     plane::BodyState m, long steps, const Look& look, double step_length = h) {
    Contacts contacts;
    for (long n = 0; n < steps; ++n) {
        const plane::BodyState before = m;
        m = plane::step(solver, body, ground, m, step_length, contacts);
        if (!look(before, m, contacts)) break;
    }
    return m;
}

}  // namespace

TEST_CASE("a step turns a point about the middle between its old and its new place", "[N42][N46][ch5]") {
    // e₂ − e = h ω × (e + e₂)/2: what makes the gap at the end of a step linear in the velocities.
    // All of it is of size h|ω||e| < 20, and some ten roundings.
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    for (int i = 0; i < 1000; ++i) {
        const Quaternion<double> q = Quaternion<double>(number(), number(), number(), 1).normalized();
        const V omega(2000 * number(), 2000 * number(), 2000 * number()), e(0, 0, 1);
        const V before = q * e, after = rotated(q, omega, h) * e;
        REQUIRE((after - before - h * omega.cross((before + after) / 2)).norm() < 20 * 16 * eps);
    }
}

TEST_CASE("the capsule does not sink into the plane", "[N49][ch5]") {
    const auto body = scene::capsule();
    std::mt19937 random(2);
    double sunk_start = 0, sunk_middle = 0;
    for (int i = 0; i < 12; ++i) {
        const auto start = scene::random_throw(body, random);
        for (const Arms arms : {Arms::start, Arms::middle})
            run(passive_gyroscopic, body, scene::ground(0.1, arms), start, 600,
                [&](const auto&, const auto& m, const Contacts& contacts) {
                    (arms == Arms::start ? sunk_start : sunk_middle) =
                        std::max(arms == Arms::start ? sunk_start : sunk_middle, contacts.sunk);
                    for (int k = 0; k < 2; ++k)  // lifted to the plane: three roundings of a metre
                        REQUIRE(m.x.z() + body.end(m.turning.q, k).z() - body.radius > -4 * eps);
                    // With the old arm the end goes h ω × e, and turns by a chord more or less:
                    // |h ω × (e₂ − e)|/2 ≤ (h|ω|)² |e|/2. What twelve rounds leave open is allowed
                    // a hundredth of that and a tenth of a millimetre.
                    const double chord = h * m.turning.omega.norm();
                    if (arms == Arms::start)
                        REQUIRE(contacts.sunk <= 1.01 * chord * chord * body.half_length / 2 + 1e-4);
                    return true;
                });
    }
    // What the middle arm leaves is the last pass's change of ω: a hundredth of the radius is a
    // millimetre and a half, and no eye sees it.
    CHECK(sunk_middle < 0.01 * body.radius);
    CHECK(sunk_start > 0.01 * body.radius);
}
