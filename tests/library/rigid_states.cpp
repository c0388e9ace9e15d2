// A body's state and angular velocity in its own axes and in the world's.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>
#include <timestep/rigid/omega.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/spin_state.hpp>
#include <timestep/rigid/strang.hpp>

using namespace timestep;
using V = Vector3<double>;
using Spin = SpinState<double>;

static constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST_CASE("a state goes to the world and back", "[library][ch8]") {
    const Spin s{2, rotation_by(V(0.3, -1, 2)), V(1, 2, 3)};
    const Spin back = in_body(in_world(s));
    CHECK((back.omega - s.omega).norm() < 8 * epsilon);
    CHECK(back.t == s.t);
    CHECK(back.q.coeffs() == s.q.coeffs());
    CHECK((in_world(s).omega - s.q * s.omega).norm() == 0);
    CHECK(!is_finite(Spin{0, Quaternion<double>(0, 0, 0, 0), V(1, 2, 3)}));
    CHECK(!is_finite(Spin{0, Quaternion<double>::Identity(), V(1, NAN, 3)}));
}

TEST_CASE("a turn by a vector is Eigen's, and none by none", "[library][ch8]") {
    for (const V& v : {V(0, 0, 0), V(1e-300, 0, 0), V(1e-9, 2e-9, 0), V(1, -2, 3)}) {
        const double angle = v.norm();
        const Quaternion<double> expected(Eigen::AngleAxis<double>(angle, angle > 0 ? V(v / angle) : V(V::UnitX())));
        CHECK((rotation_by(v).coeffs() - expected.coeffs()).norm() < 4 * epsilon);
    }
}

namespace {

// Does the call compile?
template <class State>
concept Turns = requires(PrincipalInertia<double> I, State s) {
    step_rotation(calm_half_step, I, s, 0.1);
};
template <class State>
concept Flies = requires(PrincipalInertia<double> I, State s) {
    ball_and_remainder_2.step(I, s, 0.1);
};
template <class A, class B>
constexpr bool becomes = std::is_constructible_v<B, A> || std::is_convertible_v<A, B>;

}  // namespace

// ω of the world and ω of the body: the type of the state says which, and no call takes the one for the other.
static_assert(Turns<RigidState<double>> && !Turns<Spin>);
static_assert(Flies<Spin> && !Flies<RigidState<double>>);
static_assert(!becomes<Spin, RigidState<double>> && !becomes<RigidState<double>, Spin>);

template <class Real>
constexpr bool bare = sizeof(OmegaBody<Real>) == sizeof(Vector3<Real>) &&
                      sizeof(OmegaWorld<Real>) == sizeof(Vector3<Real>) &&
                      !std::is_convertible_v<Vector3<Real>, OmegaBody<Real>> &&
                      !std::is_convertible_v<Vector3<Real>, OmegaWorld<Real>> &&
                      !std::is_constructible_v<OmegaBody<Real>, OmegaWorld<Real>> &&
                      !std::is_constructible_v<OmegaWorld<Real>, OmegaBody<Real>>;
static_assert(bare<float> && bare<double>);

TEMPLATE_TEST_CASE("an angular velocity that knows its axes takes the same step", "[library]", float, double) {
    using Real = TestType;
    using Vec = Vector3<Real>;
    const auto I = box(Real(12), Real(1), Real(2), Real(3));
    const Quaternion<Real> q = Quaternion<Real>(1, 2, 3, 4).normalized();
    const Vec w(1, -2, 3);
    const Real h = Real(0.1), epsilon = std::numeric_limits<Real>::epsilon();
    const OmegaWorld<Real> world(w);
    const OmegaBody<Real> body(w);
    CHECK(after_gyroscopic_torque(calm_half_step, I, body, h).in_the_body == calm_half_step.step(I, w, h));
    CHECK(after_gyroscopic_torque(calm_half_step, I, q, world, h).in_the_world ==
          after_gyroscopic_torque(calm_half_step, I, q, w, h));
    CHECK(after_gyroscopic_torque(calm_half_step, sphere(Real(1), Real(1)), body, h).in_the_body == w);
    CHECK((in_body(q, world).in_the_body - q.conjugate() * w).norm() < 8 * epsilon * w.norm());
    CHECK((in_world(q, in_body(q, world)).in_the_world - w).norm() < 16 * epsilon * w.norm());
    CHECK(kinetic_energy(I, body) == kinetic_energy(I, w));
    CHECK(std::fabs(kinetic_energy(I, q, world) / kinetic_energy(I, RigidState<Real>{0, q, w}) - 1) < 32 * epsilon);
}
