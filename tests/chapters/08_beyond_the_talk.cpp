// Chapter 8's appendix: books' methods and the rules of the engines.

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#ifdef TIMESTEP_WITH_BULLET
#include <BulletDynamics/Dynamics/btRigidBody.h>
#endif

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

}  // namespace

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
    const auto there_and_back = [&](const auto& method) {
        INFO(method.name);
        const Spin back = after(method, I, after(method, I, start, h), -h);
        CHECK((back.omega - start.omega).norm() < 1e-13);
        CHECK(back.q.vec().norm() < 1e-14);
    };
    there_and_back(midpoint_spin), there_and_back(moser_veselov_2), there_and_back(moser_veselov_4);
    // h|ω| = 0.4: one part; 0.8: two.
    const V w(0, 0.4, 0.01);
    CHECK(after(moser_veselov_2, I, spinning(w), 1.0).q.coeffs() ==
          moser_veselov_2.whole(I, spinning(w), 1.0).q.coeffs());
    const Spin two = after(moser_veselov_2, I, spinning(2 * w), 0.5, 2);
    CHECK((after(moser_veselov_2, I, spinning(2 * w), 1.0).q.coeffs() - two.q.coeffs()).norm() < 8 * epsilon);
    // A step that is too long, or no number, gives NaN and no endless loop.
    CHECK(after(moser_veselov_2, I, spinning({0, 10, 0}), 1e9).omega.hasNaN());
    CHECK(after(moser_veselov_4, I, spinning({0, 10, 0}), std::nan("")).omega.hasNaN());
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
