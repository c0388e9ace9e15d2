// Angular velocities that know their axes: the same numbers as bare vectors, and no more than those.
#include <catch2/catch_template_test_macros.hpp>

#include <type_traits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/rigid/omega.hpp>
#include <timestep/rigid/shapes.hpp>

using namespace timestep;

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
