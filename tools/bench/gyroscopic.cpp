// What a gyroscopic solver costs a body, beside Bullet's: world coordinates in, world coordinates
// out, in `float`. Everything runs in turns within one run, and the ratio of the fastest turns is
// what counts. `bench_gyroscopic_O2` and `bench_gyroscopic_O3_native` are this file with the flags in
// their names; Bullet is the library as it is installed.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <timestep/gyroscopic/converged_gyroscopic.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "timing.hpp"

using namespace timestep;

namespace {

constexpr int bodies = 256;  // they fit the cache
constexpr float h = 1.0f / 60;

// The target, like for like: at most so much of Bullet's time.
const bool native = std::strstr(BENCH_FLAGS, "native");
const double most = native ? 0.18 : 0.25;

// Bodies of one kind of inertia. As in Bullet, the rotation matrix is kept with the body.
template <class Inertia>
struct Body {
    using Real = typename Inertia::Scalar;
    Inertia inertia;
    Matrix3<Real> R;
    Vector3<Real> omega, change;
};

// Random size, orientation and spin, the same for everyone.
template <class Inertia, class Make>
std::vector<Body<Inertia>> make_bodies(const Make& make) {
    using Real = typename Inertia::Scalar;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> side(0.5, 2);
    std::normal_distribution<double> normal;
    std::vector<Body<Inertia>> all;
    for (int i = 0; i < bodies; ++i) {
        const Real a = Real(side(random)), b = Real(side(random)), c = Real(side(random));
        Quaternion<Real> q;
        for (int j = 0; j < 4; ++j) q.coeffs()[j] = Real(normal(random));
        Vector3<Real> omega;
        for (int j = 0; j < 3; ++j) omega[j] = Real(5 * normal(random));
        all.push_back({make(a, b, c), q.normalized().toRotationMatrix(), omega, omega});
    }
    return all;
}

struct Row {
    std::string name;
    std::function<void()> pass;  // once over all bodies
    double most = 0;             // of Bullet's time, where there is a target
    double seconds = 1e9;        // of the fastest pass
};

template <class Inertia, class Solver>
Row ours(const std::string& name, std::vector<Body<Inertia>>& all, const Solver& solver) {
    Row row;
    row.name = name;
    row.pass = [&all, solver] {
        for (auto& body : all)
            body.change = gyroscopic_change(solver, body.inertia, body.R, body.omega, typename Inertia::Scalar(h));
    };
    return row;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1) {
        std::fprintf(stderr, "bench_gyroscopic: %s: takes no options\n", argv[1]);
        return 2;
    }
    const auto as_box = [](auto a, auto b, auto c) { return box(decltype(a)(10), a, b, c); };
    const auto as_capsule = [](auto a, auto, auto c) { return capsule(decltype(a)(10), a / 2, c); };
    const auto as_full = [](float a, float b, float c) {
        return FullInertia<float>(Matrix3<float>(box(10.0f, a, b, c).moments.asDiagonal()));
    };
    auto boxes = make_bodies<PrincipalInertia<float>>(as_box);
    auto double_boxes = make_bodies<PrincipalInertia<double>>(as_box);
    auto capsules = make_bodies<SymmetricInertia<float>>(as_capsule);
    auto full = make_bodies<FullInertia<float>>(as_full);
    auto balls = make_bodies<UniformInertia<float>>([](float a, float, float) { return sphere(10.0f, a); });

    std::vector<std::unique_ptr<btRigidBody>> bullet;
    std::vector<btVector3> bullet_change(bodies);
    for (const auto& b : boxes) {
        const auto& I = b.inertia.moments;
        bullet.push_back(std::make_unique<btRigidBody>(10, nullptr, nullptr, btVector3(I.x(), I.y(), I.z())));
        btTransform place;
        place.setOrigin(btVector3(0, 0, 0));
        place.setBasis(btMatrix3x3(b.R(0, 0), b.R(0, 1), b.R(0, 2), b.R(1, 0), b.R(1, 1), b.R(1, 2), b.R(2, 0),
                                   b.R(2, 1), b.R(2, 2)));
        bullet.back()->setWorldTransform(place);
        bullet.back()->setAngularVelocity(btVector3(b.omega.x(), b.omega.y(), b.omega.z()));
    }

    std::vector<Row> rows(1);
    rows[0].name = "Bullet, implicit";
    rows[0].pass = [&] {
        for (int i = 0; i < bodies; ++i) bullet_change[i] = bullet[i]->computeGyroscopicImpulseImplicit_Body(h);
    };
    rows.push_back(ours("one iteration, three moments", boxes, implicit_gyroscopic));
    rows.back().most = most;
    // The first two are the same solver on the same bodies: they must agree before they are compared.
    rows[0].pass(), rows[1].pass();
    double worst = 0;
    for (int i = 0; i < bodies; ++i) {
        const btVector3& b = bullet_change[i];
        const Vector3<float> off = boxes[i].change - Vector3<float>(b.x(), b.y(), b.z());
        worst = std::max(worst, double(off.norm() / boxes[i].omega.norm()));
    }
    std::printf("%s\nBullet and the solver of one iteration differ by %.1e of the spin\n", BENCH_FLAGS, worst);
    if (!(worst < 1e-5)) {
        std::fprintf(stderr, "bench_gyroscopic: they are not the same solver\n");
        return 1;
    }

    rows.push_back(ours("passive, three moments", boxes, passive_gyroscopic));
    rows.push_back(ours("explicit, three moments", boxes, explicit_gyroscopic));
    rows.push_back(ours("converged, three moments", boxes, converged_gyroscopic));
    rows.push_back(ours("one iteration, two equal", capsules, implicit_gyroscopic));
    rows.push_back(ours("passive, two equal", capsules, passive_gyroscopic));
    rows.push_back(ours("one iteration, full matrix", full, implicit_gyroscopic));
    rows.push_back(ours("passive, full matrix", full, passive_gyroscopic));
    rows.push_back(ours("passive, ball: nothing", balls, passive_gyroscopic));
    rows.push_back(ours("double: one iteration", double_boxes, implicit_gyroscopic));
    rows.push_back(ours("double: passive", double_boxes, passive_gyroscopic));

    for (int turn = 0; turn < 400; ++turn)
        for (auto& row : rows) {
            const double seconds = lab::seconds_of([&] {
                for (int pass = 0; pass < 4; ++pass) row.pass();
            });
            row.seconds = std::min(row.seconds, seconds / 4);
        }
    std::printf("%-32s %10s %10s\n", "", "ns a body", "of Bullet");
    for (const auto& row : rows) {
        const double share = row.seconds / rows[0].seconds;
        std::printf("%-32s %10.2f %10.3f", row.name.c_str(), 1e9 * row.seconds / bodies, share);
        if (row.most > 0) std::printf("  target: at most %.2f%s", row.most, share > row.most ? ", misses it" : "");
        std::printf("\n");
    }
    std::printf("\n");
}
