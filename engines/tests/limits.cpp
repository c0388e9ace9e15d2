// How fast a body can get, and for which steps the half step may be taken.
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "c_functions.hpp"
#include "random_inertia.hpp"

using namespace timestep;
using V = Vector3<double>;

namespace {

double energy(const gyroscopic_body& body, const V& w) {
    return body.unit[0] * w.x() * w.x() + body.unit[1] * w.y() * w.y() + body.unit[2] * w.z() * w.z();
}

}  // namespace

// Watched in steps of a hundredth of a radian of the curve, ω is at most some (0.01)²/8 below its largest, times what a
// needle's |ω|² varies by.
TEST_CASE("in C the fastest spin is never passed, and nearly met", "[c]") {
    RandomInertia random(6);
    for (int n = 0; n < 500; ++n) {
        const auto I = random.inertia<double>(100);
        const auto body = gyroscopic_from_moments(I.moments.x(), I.moments.y(), I.moments.z());
        const V w = 10 * random.direction<double>();
        if (gyroscopic_idle(&body, w.data())) {
            CHECK(std::fabs(gyroscopic_fastest(&body, w.data()) - w.norm()) <= (w[body.middle] == 0 ? 1e-14 : 1e9));
            continue;
        }
        const double bound = gyroscopic_fastest(&body, w.data());
        double circling = 0, most = 0;
        for (int i = 0; i < 3; ++i) circling += body.circling[i] * w[i] * w[i];
        const double h = 0.01 / std::sqrt(circling);
        V now = w;
        for (int step = 0; step < 6000; ++step) {
            gyroscopic_calm_half_step(&body, now.data(), h);
            most = std::max(most, now.norm());
        }
        INFO("I = " << I.moments.transpose() << ", w = " << w.transpose());
        CHECK(most <= bound * (1 + 1e-11));
        CHECK(most >= bound * (1 - 1e-3));
    }
    // Of any size.
    const auto body = gyroscopic_from_momentsf(1, 2, 2.5f);
    const float one[] = {1, 2, 3};
    for (const int power : {-120, -60, 60, 120}) {
        const float scaled[] = {std::ldexp(1.0f, power), std::ldexp(2.0f, power), std::ldexp(3.0f, power)};
        const float expected = std::ldexp(gyroscopic_fastestf(&body, one), power);
        CHECK(std::fabs(gyroscopic_fastestf(&body, scaled) / expected - 1) < 4 * std::numeric_limits<float>::epsilon());
        const float limit = std::ldexp(gyroscopic_half_step_limitf(&body, one), -power);
        CHECK(std::fabs(gyroscopic_half_step_limitf(&body, scaled) / limit - 1) <
              4 * std::numeric_limits<float>::epsilon());
    }
}

// In equal steps E/(1 − h²p/4) stays, and p is |ω|² at most.
TEST_CASE(
    "in C the half step adds at most a percent, 7 % or a third where the first step turns by 0.2, 0.5 or 1; beyond two "
    "there is no bound",
    "[c]") {
    RandomInertia random(8);
    double most[4] = {};
    const double turns[] = {0.2, 0.5, 1, 2.2};
    for (int n = 0; n < 1000; ++n) {
        const auto I = random.inertia<double>(1000);
        const auto body = gyroscopic_from_moments(I.moments.x(), I.moments.y(), I.moments.z());
        V w = random.direction<double>();
        if (n % 2 == 1) w[body.middle] *= 100;  // where most is gained
        w *= 10 / w.norm();
        for (int k = 0; k < 4; ++k) {
            V now = w;
            for (int step = 0; step < 300; ++step) {
                gyroscopic_half_step(&body, now.data(), turns[k] / 10);
                most[k] = std::max(most[k], energy(body, now) / energy(body, w));
            }
        }
    }
    for (int k = 0; k < 3; ++k) {
        const double bound = 1 / (1 - turns[k] * turns[k] / 4);
        CAPTURE(turns[k], most[k], bound);
        CHECK(most[k] <= bound * (1 + 1e-10));
        CHECK(most[k] > 1 + 0.8 * (bound - 1));
    }
    CHECK(most[3] > 30);
}

// The bound has 1 − h²p/4 at the start, and that is 15/16 or more; the solve rounds some 40 times a step.
TEST_CASE("in C the half step up to its limit adds no more than a fifteenth to the energy", "[c]") {
    RandomInertia random(7);
    double most = 0, beyond = 0;
    for (int n = 0; n < 1000; ++n) {
        const auto I = random.inertia<double>(1000);
        const auto body = gyroscopic_from_moments(I.moments.x(), I.moments.y(), I.moments.z());
        const V w = 10 * random.direction<double>();
        const double limit = gyroscopic_half_step_limit(&body, w.data());
        if (limit == std::numeric_limits<double>::max()) continue;
        V now = w, far = w;
        for (int step = 0; step < 1000; ++step) {
            gyroscopic_half_step(&body, now.data(), limit);
            gyroscopic_half_step(&body, far.data(), 6 * limit);
            most = std::max(most, energy(body, now) / energy(body, w));
            beyond = std::max(beyond, energy(body, far) / energy(body, w));
        }
    }
    CHECK(most <= 16.0 / 15 * (1 + 1e-10));
    CHECK(most > 1.06);  // the bound is met
    CHECK(beyond > 10);
    const auto pill = gyroscopic_from_moments(1, 1, 0.3);
    CHECK(gyroscopic_half_step_limit(&pill, V(1, 2, 3).eval().data()) == std::numeric_limits<double>::max());
}
