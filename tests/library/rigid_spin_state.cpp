// A free body's state in its own axes, and the turn of a constant spin.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <timestep/rigid/spin_state.hpp>

using namespace timestep;
using V = Vector3<double>;
using Spin = SpinState<double>;

static constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST_CASE("a state goes to the world and back", "[library][ch8]") {
    const Spin s{2, turn_by(V(0.3, -1, 2)), V(1, 2, 3)};
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
        const Quaternion<double> expected(
            Eigen::AngleAxis<double>(angle, angle > 0 ? V(v / angle) : V(V::UnitX())));
        CHECK((turn_by(v).coeffs() - expected.coeffs()).norm() < 4 * epsilon);
    }
}
