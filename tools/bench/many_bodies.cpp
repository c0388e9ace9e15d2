// What one of many bodies or springs costs, in lanes, beside plain loops and other libraries: first the gyroscopic step
// of many bodies, world coordinates in, world coordinates out. As in Bullet, a body keeps its rotation matrix. A body
// in lanes is the same struct, with packs for numbers.

#include <cmath>
#include <cstdio>
#include <memory>

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif

#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/lanes.hpp>
#include <timestep/rigid/body.hpp>

#include "random_body.hpp"
#include "rows.hpp"

using namespace timestep;
using rows::Row;

int many_springs();  // many_springs.cpp

namespace {

constexpr float h = 1.0f / 60;
constexpr int count = 256;  // a multiple of the lanes

template <class Real>
struct Body {
    PrincipalInertia<Real> inertia;
    Matrix3<Real> R;
    Vector3<Real> omega, change;
};
using L = Lanes<float>;

std::vector<Body<float>> random_bodies() {
    RandomBody random(1);
    std::vector<Body<float>> all;
    for (int i = 0; i < count; ++i) {
        const Vector3<float> I = random.inertia(10).moments.cast<float>(), axis = random.direction().cast<float>();
        const Eigen::AngleAxisf turned(float(6 * random.share()), axis);
        const Vector3<float> omega = 10 * random.direction().cast<float>();
        all.push_back({{I.x(), I.y(), I.z()}, turned.toRotationMatrix(), omega, omega});
    }
    return all;
}

std::vector<Body<L>> in_lanes(const std::vector<Body<float>>& bodies) {
    std::vector<Body<L>> all;
    for (std::size_t first = 0; first < bodies.size(); first += L::lanes) {
        Vector3<L> I, omega;
        Matrix3<L> R;
        for (int i = 0; i < L::lanes; ++i) {
            const Body<float>& one = bodies[first + std::size_t(i)];
            for (int k = 0; k < 3; ++k) {
                I[k].set(i, one.inertia.moments[k]);
                omega[k].set(i, one.omega[k]);
                for (int j = 0; j < 3; ++j) R(k, j).set(i, one.R(k, j));
            }
        }
        all.push_back({{I.x(), I.y(), I.z()}, R, omega, omega});
    }
    return all;
}

template <class Real, class Solver>
[[gnu::noinline]] void pass(std::vector<Body<Real>>& all, const Solver& solver) {
    for (auto& body : all) body.change = gyroscopic_change(solver, body.inertia, body.R, body.omega, Real(h));
}

#ifdef TIMESTEP_WITH_BULLET
struct Bullet {
    explicit Bullet(const std::vector<Body<float>>& bodies) : changes(bodies.size()) {
        for (const auto& b : bodies) {
            const auto& I = b.inertia.moments;
            all.push_back(std::make_unique<btRigidBody>(10, nullptr, nullptr, btVector3(I.x(), I.y(), I.z())));
            btTransform place = btTransform::getIdentity();
            place.setBasis(btMatrix3x3(b.R(0, 0), b.R(0, 1), b.R(0, 2), b.R(1, 0), b.R(1, 1), b.R(1, 2), b.R(2, 0),
                                       b.R(2, 1), b.R(2, 2)));
            all.back()->setWorldTransform(place);
            all.back()->setAngularVelocity(btVector3(b.omega.x(), b.omega.y(), b.omega.z()));
        }
    }
    void pass() {
        for (std::size_t i = 0; i < all.size(); ++i) changes[i] = all[i]->computeGyroscopicImpulseImplicit_Body(h);
    }
    std::vector<std::unique_ptr<btRigidBody>> all;
    std::vector<btVector3> changes;
};
#endif

int many_bodies() {
    auto alone = random_bodies();
    auto lanes = in_lanes(alone);
    std::vector<Row> all;
#ifdef TIMESTEP_WITH_BULLET
    Bullet bullet(alone);
    all.push_back({"Bullet, implicit", [&] { bullet.pass(); }, count});
#endif
    const auto add = [&](const char* name, auto& bodies, const auto& solver) {
        all.push_back({name, [&bodies, solver] { pass(bodies, solver); }, count});
    };
    add("passive, one by one", alone, passive_gyroscopic);
    add("passive, lanes", lanes, passive_gyroscopic);
    add("one iteration, one by one", alone, implicit_gyroscopic);
    add("one iteration, lanes", lanes, implicit_gyroscopic);

    // They must agree before they are compared: all but the order of the last roundings.
    for (auto& row : all) row.pass();
    float worst = 0;
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const Vector3<L>& pack = lanes[i / L::lanes].change;
        const int lane = int(i % L::lanes);
        const Vector3<float>& expected = alone[i].change;
        worst = std::max(worst, (Vector3<float>(pack.x()[lane], pack.y()[lane], pack.z()[lane]) - expected).norm());
#ifdef TIMESTEP_WITH_BULLET
        const btVector3& b = bullet.changes[i];
        worst = std::max(worst, (Vector3<float>(float(b.x()), float(b.y()), float(b.z())) - expected).norm());
#endif
    }
    if (!(worst < 1e-4f)) {  // of 10 rad/s
        std::fprintf(stderr, "bench_many: one by one, in lanes and in Bullet differ: %g rad/s\n", double(worst));
        return 1;
    }

    measure(all, 200);
    std::printf("\n%-34s %10s\n", "Gyroscopic step, 256 bodies", "ns a body");
    for (const Row& row : all) std::printf("%-34s %10.3f\n", row.name.c_str(), row.nanoseconds);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (const int refused = rows::refuse_options(argc, argv)) return refused;
    std::printf("%s: %d lanes in float, %d in double\n", BENCH_FLAGS, native_width<float>, native_width<double>);
    int status = many_bodies();
    if (status == 0) status = many_springs();
    std::printf("\n");
    return status;
}
