// The C# that engines/in_your_engine.md shows keeps to what C++ understands as well: so it is
// held to gyroscopic.h.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic.h>
#include <timestep/body_throw.hpp>

namespace {

struct Vector3 {
    float x, y, z;
};
struct {
    float Abs(float a) const { return std::fabs(a); }
    float Cos(float a) const { return std::cos(a); }
    float Sin(float a) const { return std::sin(a); }
} const Mathf;

#include "passive_in_unity.cs"

float energy(Vector3 I, Vector3 w) { return I.x * w.x * w.x + I.y * w.y * w.y + I.z * w.z * w.z; }

}  // namespace

TEST_CASE("the C# for Unity is the passive step; and two equal moments in any order are a turn") {
    for (const Vector3 I : {Vector3{1, 2, 2.5f}, Vector3{2.5f, 1, 2}, Vector3{0.002f, 0.0025f, 0.001f},
                            Vector3{1, 1, 0.2f}, Vector3{0.2f, 1, 1}, Vector3{1, 0.2f, 1}})
        for (const Vector3 start : {Vector3{3, 5, -4}, Vector3{-10, 0.1f, 0.2f}, Vector3{0, 0, 7}}) {
            const gyroscopic_bodyf body = gyroscopic_from_momentsf(I.x, I.y, I.z);
            Vector3 w = start;
            float theirs[3] = {w.x, w.y, w.z};
            for (int n = 0; n < 10; ++n) {
                w = Passive(I, w, 1 / 60.0f, true);
                gyroscopic_passivef(&body, theirs, 1 / 60.0f);
            }
            CAPTURE(I.x, I.y, I.z, start.x, w.x, w.y, w.z, theirs[0], theirs[1], theirs[2]);
            CHECK(std::max({std::fabs(w.x - theirs[0]), std::fabs(w.y - theirs[1]), std::fabs(w.z - theirs[2])}) <
                  1e-4f);
        }
}

TEST_CASE(
    "by the C# for Unity a spin about the length of a capsule with nearly equal moments lasts, "
    "whatever its axis") {
    CHECK(Near(1, float(1 + 0.99 * timestep::nearly_equal)));
    CHECK_FALSE(Near(1, float(1 + 1.01 * timestep::nearly_equal)));
    for (const bool nearly : {true, false}) {
        Vector3 I{1, nearly ? 1.02f : 1, 0.18f}, w{0.1f, 0.1f, 10};
        for (int axis = 0; axis < 3; ++axis, I = Round(I), w = Round(w)) {
            Vector3 now = w;
            for (int n = 0; n < 3600; ++n) now = Passive(I, now, 1 / 60.0f, true);
            CHECK(std::fabs(energy(I, now) / energy(I, w) - 1) < 0.01f);
        }
    }
    // Within a turn the energy swings by as much as the two moments differ.
    const Vector3 I{1, 1.049f, 0.18f}, across{10, 0, 3};
    float most = 0;
    Vector3 now = across;
    for (int n = 0; n < 600; ++n) {
        now = Passive(I, now, 1 / 60.0f, true);
        most = std::max(most, energy(I, now) / energy(I, across));
    }
    CHECK(most > 1.04f);
    CHECK(most < 1.05f);
    // What does not say that it flies has the formula for three moments, two of them equal or not.
    for (const float middle : {1.0f, 1.02f}) {
        const Vector3 moments{1, middle, 0.18f}, start{0.1f, 0.1f, 10};
        Vector3 tips = start;
        for (int n = 0; n < 3600; ++n) tips = Passive(moments, tips, 1 / 60.0f);
        CHECK(energy(moments, tips) < 0.8f * energy(moments, start));
    }
    const gyroscopic_bodyf body = gyroscopic_from_momentsf(1, 1.02f, 0.18f);  // which the passive step alone tips over
    float w[3] = {0.1f, 0.1f, 10};
    for (int n = 0; n < 3600; ++n) gyroscopic_passivef(&body, w, 1 / 60.0f);
    CHECK(energy({1, 1.02f, 0.18f}, {w[0], w[1], w[2]}) < 0.8f * energy({1, 1.02f, 0.18f}, {0.1f, 0.1f, 10}));
}
