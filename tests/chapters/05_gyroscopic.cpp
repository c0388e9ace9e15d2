// Chapter 5: the capsule on the plane.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <limits>
#include <random>

#include "chapters/05_gyroscopic/study/plane_scene.hpp"

using namespace timestep;
using plane::Arms;
using plane::Contacts;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double h = 1.0 / 60;

}  // namespace

TEST_CASE("the capsule does not sink into the plane", "[N49][ch5]") {
    const auto body = scene::capsule();
    std::mt19937 random(2);
    double sunk_start = 0, sunk_middle = 0;
    for (int i = 0; i < 12; ++i) {
        const auto start = scene::random_throw(body, random);
        for (const Arms arms : {Arms::start, Arms::middle}) {
            double& sunk = arms == Arms::start ? sunk_start : sunk_middle;
            auto m = start;
            Contacts contacts;
            for (int n = 0; n < 600; ++n) {
                m = plane::step(passive_gyroscopic, body, scene::ground(0.1, arms), m, h, contacts);
                sunk = std::max(sunk, contacts.sunk);
                for (int k = 0; k < 2; ++k)  // lifted to the plane: three roundings of a metre
                    REQUIRE(m.x.z() + body.end(m.turning.q, k).z() - body.radius > -4 * eps);
                // With the old arm the end goes h ω × e, and turns by a chord more or less:
                // |h ω × (e₂ − e)|/2 ≤ (h|ω|)² |e|/2. What twelve rounds leave open is allowed
                // a hundredth of that and a tenth of a millimetre.
                const double chord = h * m.turning.omega.norm();
                if (arms == Arms::start) REQUIRE(contacts.sunk <= 1.01 * chord * chord * body.half_length / 2 + 1e-4);
            }
        }
    }
    // What the middle arm leaves is the last pass's change of ω: a hundredth of the radius is a
    // millimetre and a half, and no eye sees it.
    CHECK(sunk_middle < 0.01 * body.radius);
    CHECK(sunk_start > 0.01 * body.radius);
}
