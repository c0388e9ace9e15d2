// The step that engines/in_your_engine.md shows, in an engine of two functions.
#include "taken_home.h"

#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include <Eigen/Geometry>

namespace {

float solved = 0;

float energy(const Body& b) {  // with ω in the body: q* ω q
    using Q = Eigen::Quaternionf;
    const Eigen::Vector3f w =
        Q(b.q[3], b.q[0], b.q[1], b.q[2]).conjugate() * Eigen::Vector3f(b.omega[0], b.omega[1], b.omega[2]);
    float sum = 0;
    for (int i = 0; i < 3; ++i) sum += w[i] * w[i] / b.inverse_moments[i] / 2;
    return sum;
}

}  // namespace

void solve_contacts_and_joints(Body*, float h) { solved += h; }
void turn(Body* b, float h) {
    const Eigen::Vector3f w(b->omega[0], b->omega[1], b->omega[2]);
    const Eigen::Quaternionf q =
        (Eigen::AngleAxisf(h * w.norm(), w.normalized()) * Eigen::Quaternionf(b->q[3], b->q[0], b->q[1], b->q[2]))
            .normalized();
    b->q[0] = q.x(), b->q[1] = q.y(), b->q[2] = q.z(), b->q[3] = q.w();
}

TEST_CASE("the step that the page shows keeps a box tumbling for a minute") {
    Body b{{0, 0, 0, 1}, {0.1f, 10, 0.1f}, {1 / 13.0f, 1 / 10.0f, 1 / 5.0f}, {}};
    after_loading(&b);
    const float E = energy(b);
    bool turned_over = false;
    for (int n = 0; n < 3600; ++n) {
        step(&b, 1 / 60.0f);
        const Eigen::Quaternionf q(b.q[3], b.q[0], b.q[1], b.q[2]);
        turned_over = turned_over || (q.conjugate() * Eigen::Vector3f(b.omega[0], b.omega[1], b.omega[2])).y() < -5;
    }
    CHECK(std::fabs(energy(b) / E - 1) < 0.01f);
    CHECK(turned_over);
    CHECK(std::fabs(solved - 60) < 0.01f);
}

TEST_CASE("a step of zero changes no bit, however far apart the numbers of a spin are") {
    const float spin[3] = {3e6f, 1e-25f, 1};
    for (const gyroscopic_bodyf& body : {gyroscopic_from_momentsf(1, 2, 2.5f), gyroscopic_from_momentsf(1, 1, 1)})
        for (const auto rule : {gyroscopic_passivef, gyroscopic_half_stepf, gyroscopic_calm_half_stepf}) {
            float w[3] = {spin[0], spin[1], spin[2]}, q[4] = {0.1f, 0.7f, 0.1f, 0.7f};
            rule(&body, w, 0);
            gyroscopic_ball_and_remainder_2f(&body, q, w, 0);
            gyroscopic_ball_and_remainder_4_in_worldf(&body, q, w, 0);
            CHECK((w[0] == spin[0] && w[1] == spin[1] && w[2] == spin[2]));
            CHECK((q[0] == 0.1f && q[1] == 0.7f && q[3] == 0.7f));
            w[0] = w[1] = w[2] = 0;
            gyroscopic_ball_and_remainder_2f(&body, q, w, 1);
            CHECK((w[0] == 0 && q[0] == 0.1f));
        }
}
