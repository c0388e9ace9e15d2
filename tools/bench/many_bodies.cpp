// The gyroscopic step of many bodies: world coordinates in, world coordinates out. As in Bullet, a body keeps its
// rotation matrix. A body in lanes is the same struct, with packs for numbers.

#include "many.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <random>

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif

#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/lanes.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>

using namespace timestep;

namespace {

constexpr float h = 1.0f / 60;

template <class Inertia>
struct Body {
    Inertia inertia;
    Matrix3<typename Inertia::Scalar> R;
    Vector3<typename Inertia::Scalar> omega, change;
};

// The same random boxes for everyone; their sides by way of a pack's lanes or as numbers.
template <class Real>
struct Crates {
    explicit Crates(int count) {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> side(0.5, 2);
        std::normal_distribution<double> normal;
        for (int i = 0; i < count; ++i) {
            sides.push_back({Real(side(random)), Real(side(random)), Real(side(random))});
            Quaternion<Real> q;
            for (int k = 0; k < 4; ++k) q.coeffs()[k] = Real(normal(random));
            R.push_back(q.normalized().toRotationMatrix());
            omega.push_back({Real(5 * normal(random)), Real(5 * normal(random)), Real(5 * normal(random))});
        }
    }
    std::vector<Vector3<Real>> sides, omega;
    std::vector<Matrix3<Real>> R;
};

template <class Real>
std::vector<Body<PrincipalInertia<Real>>> one_by_one(const Crates<Real>& crates) {
    std::vector<Body<PrincipalInertia<Real>>> all;
    for (std::size_t i = 0; i < crates.R.size(); ++i) {
        const Vector3<Real>& s = crates.sides[i];
        all.push_back({box(Real(10), s.x(), s.y(), s.z()), crates.R[i], crates.omega[i], crates.omega[i]});
    }
    return all;
}

// Their number is a multiple of the lanes.
template <class Real>
std::vector<Body<PrincipalInertia<Lanes<Real>>>> in_lanes(const Crates<Real>& crates) {
    using L = Lanes<Real>;
    std::vector<Body<PrincipalInertia<L>>> all;
    for (std::size_t first = 0; first < crates.R.size(); first += L::lanes) {
        Vector3<L> sides, omega;
        Matrix3<L> R;
        for (int i = 0; i < L::lanes; ++i) {
            const std::size_t one = first + std::size_t(i);
            for (int k = 0; k < 3; ++k) {
                sides[k].set(i, crates.sides[one][k]);
                omega[k].set(i, crates.omega[one][k]);
                for (int j = 0; j < 3; ++j) R(k, j).set(i, crates.R[one](k, j));
            }
        }
        all.push_back({box(L(10), sides.x(), sides.y(), sides.z()), R, omega, omega});
    }
    return all;
}

template <class Inertia, class Solver>
[[gnu::noinline]] void pass(std::vector<Body<Inertia>>& all, const Solver& solver) {
    const typename Inertia::Scalar step(h);
    for (auto& body : all) body.change = gyroscopic_change(solver, body.inertia, body.R, body.omega, step);
}

template <class Inertia, class Solver>
many::Row row(const std::string& name, std::vector<Body<Inertia>>& all, const Solver& solver, int count) {
    return {name, [&all, solver] { pass(all, solver); }, double(count)};
}

}  // namespace

int many::bodies() {
    constexpr int few = 256, lots = 1 << 17;  // within the caches, and beyond them
    const Crates<float> crates(few), all_crates(lots);
    const Crates<double> double_crates(few);
    auto alone = one_by_one(crates);
    auto lanes = in_lanes(crates);
    auto double_lanes = in_lanes(double_crates);
    auto lots_alone = one_by_one(all_crates);
    auto lots_lanes = in_lanes(all_crates);
    std::vector<Body<UniformInertia<Lanes<float>>>> balls;
    for (const auto& b : lanes) balls.push_back({sphere(Lanes<float>(10), Lanes<float>(1)), b.R, b.omega, b.change});

    std::vector<Row> rows;
#ifdef TIMESTEP_WITH_BULLET
    std::vector<std::unique_ptr<btRigidBody>> bullet;
    std::vector<btVector3> bullet_change(few);
    for (const auto& b : alone) {
        const auto& I = b.inertia.moments;
        bullet.push_back(std::make_unique<btRigidBody>(10, nullptr, nullptr, btVector3(I.x(), I.y(), I.z())));
        btTransform place;
        place.setOrigin(btVector3(0, 0, 0));
        place.setBasis(btMatrix3x3(b.R(0, 0), b.R(0, 1), b.R(0, 2), b.R(1, 0), b.R(1, 1), b.R(1, 2), b.R(2, 0),
                                   b.R(2, 1), b.R(2, 2)));
        bullet.back()->setWorldTransform(place);
        bullet.back()->setAngularVelocity(btVector3(b.omega.x(), b.omega.y(), b.omega.z()));
    }
    rows.push_back({"Bullet, implicit",
                    [&] {
                        for (int i = 0; i < few; ++i)
                            bullet_change[std::size_t(i)] =
                                bullet[std::size_t(i)]->computeGyroscopicImpulseImplicit_Body(h);
                    },
                    few});
#endif
    const std::size_t first_of_ours = rows.size();
    rows.push_back(row("one iteration, one by one", alone, implicit_gyroscopic, few));
    rows.push_back(row("passive, one by one", alone, passive_gyroscopic, few));
    rows.push_back(row("one iteration, lanes", lanes, implicit_gyroscopic, few));
    rows.push_back(row("passive, lanes", lanes, passive_gyroscopic, few));
    rows.push_back(row("double: one iteration, lanes", double_lanes, implicit_gyroscopic, few));
    rows.push_back(row("double: passive, lanes", double_lanes, passive_gyroscopic, few));
    rows.push_back(row("balls, lanes: nothing", balls, passive_gyroscopic, few));
    rows.push_back(row("131072, one by one", lots_alone, implicit_gyroscopic, lots));
    rows.push_back(row("131072, lanes", lots_lanes, implicit_gyroscopic, lots));

    // They must agree before they are compared: all but the order of the last roundings.
    for (auto& r : rows) r.pass();
    pass(alone, implicit_gyroscopic), pass(lanes, implicit_gyroscopic);
    double worst = 0;
    for (std::size_t i = 0; i < few; ++i) {
        const auto& in = lanes[i / Lanes<float>::lanes];
        const int lane = int(i % Lanes<float>::lanes);
        Vector3<float> off(in.change.x()[lane], in.change.y()[lane], in.change.z()[lane]);
        const Vector3<float> expected = alone[i].change;
        worst = std::max(worst, double((off - expected).norm() / alone[i].omega.norm()));
#ifdef TIMESTEP_WITH_BULLET
        const btVector3& b = bullet_change[i];
        off -= Vector3<float>(b.x(), b.y(), b.z());
        worst = std::max(worst, double(off.norm() / alone[i].omega.norm()));
#endif
    }
    if (!(worst < 1e-5)) {
        std::fprintf(stderr, "bench_many: one by one, in lanes and in Bullet differ: %g\n", worst);
        return 1;
    }

    measure(rows, 200);
    const bool peer = first_of_ours > 0;
    std::printf("\n%-34s %10s %10s\n", "Gyroscopic step, 256 bodies", "ns a body", peer ? "of Bullet" : "");
    const bool native = std::strstr(BENCH_FLAGS, "native");
    for (const Row& r : rows) {
        std::printf("%-34s %10.3f", r.name.c_str(), r.nanoseconds);
        if (peer) {
            const double share = r.nanoseconds / rows[0].nanoseconds;
            std::printf(" %10.4f", share);
            if (r.name == "one iteration, one by one") std::printf("%s", target(share, native ? 0.18 : 0.25).c_str());
            if (r.name == "one iteration, lanes") std::printf("%s", target(share, native ? 0.012 : 0.05).c_str());
        }
        std::printf("\n");
    }
    if (!peer) std::printf("Bullet is not installed (package libbullet-dev)\n");
    return 0;
}
