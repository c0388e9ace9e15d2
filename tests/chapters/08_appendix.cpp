// The claims of chapter 8's appendix: books' methods and the rules of the engines.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif

#include <timestep/measured_order.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "engines/rules.hpp"
#include "random_inertia.hpp"
#include "spins.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;
using Spin = SpinState<double>;
using Body = PrincipalInertia<double>;

const double h = 1.0 / 60;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Rule {
    const char* name;
    int order;
    Spin (*after)(const Body& I, Spin s, double step, long steps);
};
template <class Method>
Rule rule(const Method&) {
    return {Method::name, Method::order,
            [](const Body& I, Spin s, double step, long steps) { return after(Method{}, I, s, step, steps); }};
}

double energy_off(const Body& I, const Spin& s, const V& omega) {
    return std::fabs(kinetic_energy(I, s.omega) / kinetic_energy(I, omega) - 1);
}
// The angular momentum in the world.
double momentum_off(const Body& I, const Spin& s, const V& omega) {
    const V L = I.momentum(omega);
    return (s.q * I.momentum(s.omega) - L).norm() / L.norm();
}
double moment(const Body& I, const V& omega) {
    return I.momentum(omega).squaredNorm() / (2 * kinetic_energy(I, omega));
}

const Rule exact_rules[] = {rule(midpoint_spin), rule(moser_veselov_2), rule(moser_veselov_4)};

}  // namespace

TEST_CASE("each method of the appendix has its order in the spin and in the orientation", "[ch8]") {
    const Body bodies[] = {box(12.0, 1.0, 2.0, 3.0), {1, 1.1, 0.3}, {3, 1.2, 2}};
    std::vector<Rule> all;
    for_each_other([&](const auto& method) { all.push_back(rule(method)); });
    for (const Body& I : bodies)
        for (const Rule& method : all) {
            INFO(method.name << ", I = " << I.moments.transpose());
            const Spin start = spinning({2, 1, 2});
            const Spin exact = in_body(ExactFreeBody<double>(I, in_world(start))(2));
            std::vector<double> steps, spins, orientations;
            const long least = method.order == 4 ? 32 : 256;
            for (long n = least; n <= 8 * least; n *= 2) {
                const Spin s = method.after(I, start, 2.0 / double(n), n);
                steps.push_back(2.0 / double(n));
                spins.push_back((s.omega - exact.omega).norm());
                orientations.push_back((s.q.conjugate() * exact.q).vec().norm());
            }
            CHECK(std::fabs(measured_order(steps, spins) - method.order) < 0.2);
            CHECK(std::fabs(measured_order(steps, orientations) - method.order) < 0.2);
        }
}

// Each turn of L and each solve leaves a few ε; with n parts they add up to less than 32 n ε. Were
// order four's moments far from the body's, it would show here, too: ratios go to a million.
TEST_CASE("implicit midpoint and Moser-Veselov keep energy and L, whatever the step", "[ch8]") {
    RandomInertia random(21);
    for (const double size : {1e-3, 0.3, 1.0, 10.0, 300.0})
        for (int n = 0; n < 40; ++n) {
            const Body I = random.inertia<double>(n % 2 ? 10 : 1e6);
            const V w = size * random.direction<double>();
            for (const Rule& method : exact_rules) {
                INFO(method.name << ", h|ω| = " << size << ", I = " << I.moments.transpose()
                                 << ", ω = " << w.transpose());
                const Spin s = method.after(I, spinning(w), 1.0, 3);
                const double parts = 3 * (1 + 4 * size);  // |ω| rises to at most √2 of the start
                CHECK(energy_off(I, s, w) < 32 * parts * epsilon);
                CHECK(momentum_off(I, s, w) < 32 * parts * epsilon);
            }
        }
}

TEST_CASE("the appendix's methods solve the equations that they say", "[ch8]") {
    RandomInertia random(22);
    for (int n = 0; n < 200; ++n) {
        const Body I = random.inertia<double>(100);
        const V w = 0.9 * random.direction<double>();
        const V L = I.momentum(w);
        // Implicit midpoint, with half the step.
        const V m = (after(midpoint_spin, I, spinning(w), 0.5).omega + w) / 2;
        const V torque = m.cross(I.momentum(m));
        CHECK((2 * I.momentum(m - w) + 0.5 * torque).norm() < 64 * epsilon * L.norm());
        // Moser-Veselov: h/2 L of the turn that the orientation made.
        const Quaternion<double> rho = after(moser_veselov_2, I, spinning(w), 0.5).q;
        const V e = rho.vec(), pairs(e.y() * e.z(), e.z() * e.x(), e.x() * e.y());
        const V left = rho.w() * I.momentum(e) + I.momentum(I.ratio.cwiseProduct(pairs));
        CHECK((left - 0.25 * L).norm() < 64 * epsilon * L.norm());
        // ODE's matrix.
        const V ode = after(ode_spin, I, spinning(w), 0.5).omega;
        CHECK((I.momentum(ode) - 0.5 * L.cross(ode) - L).norm() < 64 * epsilon * L.norm());
        // Jolt: along L − h ω × L, as long as L.
        const V jolt = I.momentum(after(jolt_spin, I, spinning(w), 0.5).omega);
        const V along = L - 0.5 * w.cross(L);
        CHECK(std::fabs(jolt.norm() / L.norm() - 1) < 16 * epsilon);
        CHECK((jolt.normalized() - along.normalized()).norm() < 16 * epsilon);
    }
}

TEST_CASE("what keeps everything is reversible; a step is cut up no more than needed", "[ch8]") {
    const Body I = box(1.0, 1.0, 2.0, 3.0);
    const Spin start = spinning({1, 2, 10});
    for (const Rule& method : exact_rules) {
        INFO(method.name);
        const Spin back = method.after(I, method.after(I, start, h, 1), -h, 1);
        CHECK((back.omega - start.omega).norm() < 1e-13);
        CHECK(back.q.vec().norm() < 1e-14);
    }
    // h|ω| = 0.4: one part; 0.8: two.
    const V w(0, 0.4, 0.01);
    CHECK(after(moser_veselov_2, I, spinning(w), 1.0).q.coeffs() ==
          moser_veselov_2.whole(I, spinning(w), 1.0).q.coeffs());
    const Spin two = after(moser_veselov_2, I, spinning(2 * w), 0.5, 2);
    CHECK((after(moser_veselov_2, I, spinning(2 * w), 1.0).q.coeffs() - two.q.coeffs()).norm() < 8 * epsilon);
}

TEST_CASE("Buss's steps keep L in the world, and a body that turns about its axis keeps turning", "[ch8]") {
    RandomInertia random(23);
    for (const double size : {1e-3, 0.3, 3.0})
        for (int n = 0; n < 40; ++n) {
            const Body I = random.inertia<double>(100);
            const V w = size * random.direction<double>();
            for (const Rule& method : {rule(buss_2), rule(buss_augmented)}) {
                INFO(method.name << ", h|ω| = " << size);
                CHECK(momentum_off(I, method.after(I, spinning(w), 1.0, 50), w) < 50 * 16 * epsilon);
            }
        }
    // A symmetric body, whose mean spin is known: the term more takes its error in a step from h³ to h⁴.
    const Body I(1, 1, 0.5);
    const V w(1, 0, 2);
    const auto off = [&](const Rule& method, double step) {
        const Spin exact = in_body(ExactFreeBody<double>(I, in_world(spinning(w)))(step));
        return (method.after(I, spinning(w), step, 1).q.conjugate() * exact.q).vec().norm();
    };
    CHECK(std::fabs(std::log2(off(rule(buss_2), 0.02) / off(rule(buss_2), 0.01)) - 3) < 0.1);
}

TEST_CASE("Spiers's steps keep |L|, a symmetric body's whole motion, and of others the energy to order two", "[ch8]") {
    RandomInertia random(27);
    for (const double size : {1e-3, 0.3, 3.0, 1e3})
        for (int n = 0; n < 40; ++n) {
            const Body I = random.inertia<double>(100);
            const V w = size * random.direction<double>();
            const Spin whole = after(spiers_spin, I, spinning(w), 1.0, 50),
                       spin = after(avian_spin, I, spinning(w), 1.0, 50);
            INFO("h|ω| = " << size << ", I = " << I.moments.transpose());
            CHECK(momentum_off(I, whole, w) < 50 * 32 * epsilon * (1 + size));  // an angle is rounded, too
            CHECK(std::fabs(I.momentum(spin.omega).norm() / I.momentum(w).norm() - 1) < 50 * 16 * epsilon);
        }
    // Whichever axis is the odd one, in steps of any length. (The exact solution is off by a roundoff of its angle.)
    for (const V& moments : {V(1, 1, 0.4), V(1.7, 1, 1), V(1, 0.2, 1)}) {
        const Body I(moments.x(), moments.y(), moments.z());
        const V w(1, 2, 3);
        const Spin exact = in_body(ExactFreeBody<double>(I, in_world(spinning(w)))(20));
        const Spin whole = after(spiers_spin, I, spinning(w), 2.0, 10);
        CHECK((whole.omega - exact.omega).norm() < 1e-12);
        CHECK((whole.q.conjugate() * exact.q).vec().norm() < 1e-12);
        CHECK((after(avian_spin, I, spinning(w), 2.0, 10).omega - exact.omega).norm() < 1e-12);
    }
    // In a step the energy is off by h³ where the first two derivatives vanish; Jolt's by h².
    const Body I = box(1.0, 1.0, 2.0, 3.0);
    const auto order = [&](const auto& method) {
        return std::log2(energy_off(I, after(method, I, spinning({1, 2, 3}), 0.02), {1, 2, 3}) /
                         energy_off(I, after(method, I, spinning({1, 2, 3}), 0.01), {1, 2, 3}));
    };
    CHECK(std::fabs(order(avian_spin) - 3) < 0.1);
    CHECK(std::fabs(order(jolt_spin) - 2) < 0.1);
    for (const V& still : {V(0, 0, 0), V(0, 3, 0)})
        CHECK((after(avian_spin, I, spinning(still), 1.0).omega - still).norm() <= 8 * epsilon * still.norm());
}

TEST_CASE("Adams-Bashforth goes on from its last slope, and anew after an impulse", "[ch8]") {
    const Body I = box(12.0, 1.0, 2.0, 3.0);
    const Spin start = spinning({1, 2, 3});
    AdamsBashforthSpin<double> rule;
    const Spin one = rule.step(I, start, h), two = rule.step(I, one, h);
    const auto slope = [&](const Spin& s) -> V { return I.momentum(s.omega).cross(s.omega).cwiseQuotient(I.moments); };
    CHECK(one.omega == buss_2.step(I, start, h).omega);
    CHECK((two.omega - one.omega - h / 2 * (3 * slope(one) - slope(start))).norm() < 8 * epsilon);
    Spin pushed = two;
    pushed.omega.x() += 1;
    CHECK(rule.step(I, pushed, h).omega == buss_2.step(I, pushed, h).omega);
    const Spin three = rule.step(I, start, h);
    CHECK(rule.step(I, three, h / 2).omega == buss_2.step(I, three, h / 2).omega);
}

TEST_CASE("without its parts Moser-Veselov has no step for h|omega| above 1 about an axis", "[ch8]") {
    const Body I = box(1.0, 1.0, 2.0, 3.0);
    const auto off = [&](double size) {  // of h ω = 2 e₀ e
        const Quaternion<double> rho = moser_veselov_2.whole(I, spinning({0, size, 0}), 1.0).q;
        return std::fabs(2 * rho.w() * rho.y() - size);
    };
    CHECK(off(0.99) < 1e-12);
    CHECK_FALSE(off(1.01) < 1e-3);
    CHECK_FALSE(off(1.5) < 0.1);
    const V w(0, 10, 0);
    CHECK(energy_off(I, after(moser_veselov_2, I, spinning(w), 1.0), w) < 1e-13);
    CHECK(after(moser_veselov_2, I, spinning(w), 0.0).omega == w);
    CHECK(after(moser_veselov_2, I, spinning({0, 0, 0}), 1.0).omega == V(0, 0, 0));
    // Too long, or no number: NaN, and no endless loop.
    CHECK(after(moser_veselov_2, I, spinning(w), 1e9).omega.hasNaN());
    CHECK(after(moser_veselov_4, I, spinning(w), std::nan("")).omega.hasNaN());
}

TEST_CASE("Magnus-Taylor keeps L, and for short steps the energy", "[ch8]") {
    const Body I = box(1.0, 1.0, 2.0, 3.0);
    const V w(1, 10, 0.1);
    const Spin minute = after(magnus_taylor, I, spinning(w), h, 3600);
    CHECK(energy_off(I, minute, w) < 1e-3);
    CHECK(momentum_off(I, minute, w) < 3600 * 8 * epsilon);
    double most = 0;  // at h|ω| = 1 it does not
    RandomInertia random(26);
    for (int n = 0; n < 100; ++n) {
        const Body body = random.inertia<double>(100);
        const V start = random.direction<double>();
        Spin s = spinning(start);
        for (int i = 0; i < 100; ++i) {
            s = after(magnus_taylor, body, s, 1.0);
            most = std::max(most, kinetic_energy(body, s.omega) / kinetic_energy(body, start));
        }
        CHECK(momentum_off(body, s, start) < 100 * 8 * epsilon);
    }
    CHECK(most > 2);
}

TEST_CASE("Jolt's rule ends about the intermediate axis, ODE's about the largest moment's", "[ch8]") {
    RandomInertia random(23);
    for (int n = 0; n < 20; ++n) {
        const Body I = random.inertia<double>(5);
        V moments = I.moments;
        std::sort(moments.begin(), moments.end());
        const V w = V(1, 2, 3 + n).normalized() * 10;
        INFO("I = " << I.moments.transpose());
        const Spin jolt = after(jolt_spin, I, spinning(w), h, 40000);
        CHECK(std::fabs(moment(I, jolt.omega) / moments[1] - 1) < 0.01);
        CHECK(std::fabs(I.momentum(jolt.omega).norm() / I.momentum(w).norm() - 1) < 1e-10);
        const Spin ode = after(ode_spin, I, spinning(w), h, 40000);
        CHECK(std::fabs(moment(I, ode.omega) / moments[2] - 1) < 0.01);
        CHECK(kinetic_energy(I, ode.omega) <= kinetic_energy(I, w));
    }
    // About the largest moment, where a body would stay for ever, Jolt's rule adds energy.
    const Body plate(1, 1.2, 2);
    const Spin thrown = after(jolt_spin, plate, spinning({0.5, 0.5, 10}), h, 36000);
    CHECK(kinetic_energy(plate, thrown.omega) > 1.5 * kinetic_energy(plate, V(0.5, 0.5, 10)));
}

TEST_CASE("Godot's rule keeps the energy and not L, explicit Euler's blows up", "[ch8]") {
    const Body I = box(1.0, 1.0, 2.0, 3.0);
    const V w(1, 10, 0.1);
    const Spin godot = after(godot_spin, I, spinning(w), h, 600);
    CHECK(godot.omega == w);
    CHECK(momentum_off(I, after(godot_spin, I, spinning({5, 5, 5}), h, 20), {5, 5, 5}) > 0.1);
    CHECK_FALSE(energy_off(I, after(explicit_spin, I, spinning(w), h, 3600), w) < 1e6);
}

TEST_CASE("while no guard acts, Box3D, Bullet and MuJoCo take the talk's step", "[ch8]") {
    RandomInertia random(24);
    for (int n = 0; n < 300; ++n) {
        const Body like = random.inertia<double>(20);
        const V I = like.moments / like.moments.maxCoeff();
        const Body inertia(I.x(), I.y(), I.z());
        const V w = random.direction<double>();
        const V talk = implicit_gyroscopic.step(inertia, w, 0.1);
        CHECK((after(mujoco_spin, inertia, spinning(w), 0.1).omega - talk).norm() == 0);
        CHECK((after(bullet_spin, inertia, spinning(w), 0.1).omega - talk).norm() < 1e-12);
        CHECK((Box3dGyroscopic{}.step(inertia, w, 0.1) - talk).norm() < 1e-12);
        const Spin four = after(mujoco_spin, inertia, spinning(w), 0.1, 4);
        CHECK((after(box3d_spin, inertia, spinning(w), 0.4).omega - four.omega).norm() < 1e-11);
    }
}

TEST_CASE("in float Bullet's guard drops a light body's torque, Box3D's a speck's", "[ch8]") {
    const Vector3<float> w(1, 10, 1);
    const auto change = [&](const auto& solver, float size) {
        const PrincipalInertia<float> I(size, 0.8f * size, 0.5f * size);
        const Vector3<float> talk = implicit_gyroscopic.step(I, w, 1 / 60.0f) - w;
        return (solver.step(I, w, 1 / 60.0f) - w).norm() / talk.norm();
    };
    // 0.4 size³ against ε = 1.2e-7, and against 1.2e-35.
    CHECK(std::fabs(change(BulletGyroscopic{}, 0.007f) - 1) < 1e-3f);
    CHECK(change(BulletGyroscopic{}, 0.006f) < 1e-6f);
    CHECK(std::fabs(change(Box3dGyroscopic{}, 0.006f) - 1) < 1e-3f);
    CHECK(std::fabs(change(Box3dGyroscopic{}, 4e-12f) - 1) < 1e-3f);
    CHECK(change(Box3dGyroscopic{}, 2e-12f) == 0);
}

TEST_CASE("Box3D caps the spin at an eighth of a turn a step", "[ch8]") {
    const Body I = box(1.0, 1.0, 2.0, 3.0);
    const Spin fast = after(box3d_spin, I, spinning({100, 0, 0}), h);
    CHECK(std::fabs(fast.omega.norm() * h - 0.25 * 3.14159265358979) < 1e-12);
    CHECK(after(box3d_spin, I, spinning({47, 0, 0}), h).omega == V(47, 0, 0));
    RandomInertia random(25);
    double most = 0;
    for (int n = 0; n < 20000; ++n) {
        const Body body = random.inertia<double>(1000);
        const V w = random.direction<double>();
        const V next = Box3dGyroscopic{}.step(body, w, 0.25 * 3.14159265358979 / 4);
        most = std::max(most, kinetic_energy(body, next) / kinetic_energy(body, w));
    }
    CHECK(most < 1.05);
}

#ifdef TIMESTEP_WITH_BULLET
TEST_CASE("Bullet itself does what its rule here does, guard and all", "[ch8]") {
    using Real = btScalar;
    const Real least = std::cbrt(std::numeric_limits<Real>::epsilon());
    for (const Real size : {Real(0.1), Real(0.7), Real(1.3), Real(2), Real(100)}) {
        const PrincipalInertia<Real> I(size * least, Real(0.8) * size * least, Real(1.1) * size * least);
        const btVector3 moments(I.moments.x(), I.moments.y(), I.moments.z());
        btRigidBody body(1, nullptr, nullptr, moments);
        body.setAngularVelocity(btVector3(1, 10, 2));
        const btVector3 change = body.computeGyroscopicImpulseImplicit_Body(Real(1) / 60);
        const Vector3<Real> w(1, 10, 2);
        const Vector3<Real> ours = BulletGyroscopic{}.step(I, w, Real(1) / 60) - w;
        INFO("size " << size);
        CHECK((Vector3<Real>(change.x(), change.y(), change.z()) - ours).norm() <
              64 * std::numeric_limits<Real>::epsilon() * w.norm());
    }
}
#endif
