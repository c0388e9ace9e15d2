// Packs of numbers: what one lane computes is what one number computes.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/lanes.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/strang.hpp>
#include <timestep/rigid/tumble.hpp>

using namespace timestep;
using Catch::Matchers::Message;

namespace {

// The same bits: −0 is not 0. (No NaN is made here.)
template <class Real>
bool same(Real a, Real b) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

template <class L, class Make>
L made(const Make& make) {
    L all(0);
    for (int i = 0; i < L::lanes; ++i) all.set(i, typename L::Number(make()));
    return all;
}

std::mt19937 random_engine(8);
double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_engine);
}

// What lane `i` of a pack's state or vector holds.
template <class L>
State<typename L::Number> lane(const State<L>& s, int i) {
    return {s.t[i], s.x[i], s.v[i]};
}
template <class L, int Size>
Eigen::Matrix<typename L::Number, Size, 1> lane(const Eigen::Matrix<L, Size, 1>& v, int i) {
    Eigen::Matrix<typename L::Number, Size, 1> one;
    for (int k = 0; k < Size; ++k) one[k] = v[k][i];
    return one;
}

template <class Real, int N>
using Loop = Lanes<Real, N, detail::ArrayPack<Real, N>>;  // as where the compiler has no vectors

}  // namespace

#define TIMESTEP_ALL_LANES Lanes<float>, Lanes<double>, (Loop<float, 4>), (Loop<double, 2>)

TEMPLATE_TEST_CASE("a lane computes what one number does, to the last bit", "[library][ch8]",
                   TIMESTEP_ALL_LANES) {
    using L = TestType;
    using Real = typename L::Number;
    for (int n = 0; n < 1000; ++n) {
        const L a = made<L>([] { return between(-3, 3); }),
                b = made<L>([] { return between(1, 9); });
        L sum = a, difference = a, product = a, quotient = a;
        sum += b, difference -= b, product *= b, quotient /= b;
        const L minus = -a, root = sqrt(b), third = cbrt(a), sine = sin(a), cosine = cos(a);
        const L mixed = 2 * a + 1 / b - Real(0.5);
        for (int i = 0; i < L::lanes; ++i) {
            REQUIRE(same(sum[i], a[i] + b[i]));
            REQUIRE(same(difference[i], a[i] - b[i]));
            REQUIRE(same(product[i], a[i] * b[i]));
            REQUIRE(same(quotient[i], a[i] / b[i]));
            REQUIRE(same(minus[i], -a[i]));
            REQUIRE(same(root[i], std::sqrt(b[i])));
            REQUIRE(same(third[i], std::cbrt(a[i])));
            REQUIRE(same(sine[i], std::sin(a[i])));
            REQUIRE(same(cosine[i], std::cos(a[i])));
            REQUIRE(same(mixed[i], 2 * a[i] + 1 / b[i] - Real(0.5)));
        }
    }
    const Real inf = std::numeric_limits<Real>::infinity();
    for (const Real value : {Real(0), -Real(0), inf, -inf, std::numeric_limits<Real>::denorm_min()})
        for (int i = 0; i < L::lanes; ++i) REQUIRE(same(L(value)[i], value));
    CHECK(std::isnan(L(std::numeric_limits<Real>::quiet_NaN())[L::lanes - 1]));
}

TEMPLATE_TEST_CASE("every method steps a pack of springs as it steps each, to the last bit",
                   "[library][ch8]", TIMESTEP_ALL_LANES) {
    using L = TestType;
    using Real = typename L::Number;
    const L omega = made<L>([] { return between(0, 20); });
    const L zeta = made<L>([] { return between(0, 2); });
    const Real h = Real(0.01);
    const auto compare = [&](const auto& method, const auto& packed, const auto& one_of) {
        State<L> s{0, made<L>([] { return between(-1, 1); }),
                   made<L>([] { return between(-1, 1); })};
        std::vector<State<Real>> one;
        for (int i = 0; i < L::lanes; ++i) one.push_back(lane(s, i));
        for (int n = 0; n < 200; ++n) {
            if constexpr (requires { method.step(packed, s, L(h)); })
                s = method.step(packed, s, L(h));
            else
                s = method.step(packed, s, s, L(h));  // of two states; here the same one twice
            for (int i = 0; i < L::lanes; ++i) {
                if constexpr (requires { method.step(one_of(i), one[0], h); })
                    one[std::size_t(i)] = method.step(one_of(i), one[std::size_t(i)], h);
                else
                    one[std::size_t(i)] =
                        method.step(one_of(i), one[std::size_t(i)], one[std::size_t(i)], h);
                const State<Real>& by_itself = one[std::size_t(i)];
                INFO(method.name << ", step " << n << ", lane " << i);
                REQUIRE(same(s.t[i], by_itself.t));
                REQUIRE(same(s.x[i], by_itself.x));
                REQUIRE(same(s.v[i], by_itself.v));
            }
        }
    };
    const auto spring = [&](const auto& method) {
        compare(method, Spring<L>(omega), [&](int i) { return Spring<Real>(omega[i]); });
    };
    const auto damped = [&](const auto& method) {
        compare(method, DampedSpring<L>(omega, zeta),
                [&](int i) { return DampedSpring<Real>(omega[i], zeta[i]); });
    };
    for_each_method([&](const auto& method) { spring(method), damped(method); });
    for_each_verlet_method([&](const auto& method) {
        if constexpr (!std::is_same_v<std::decay_t<decltype(method)>, Newton>) spring(method);
    });
}

// In `float` the lanes' bits are those of one body. In `double` Eigen may take a sum of three
// products two at a time, in another order than a pack does: either is off by 3 roundings of the
// sum of the sizes, at most √3 |ω| in a row of a rotation. A change of coordinates, a solver with
// two or three such sums over a number near one, and the way back: 8 sums at the most, 48 roundings
// or 24 ε. The attitude is a sum of five products, over its length: 8 ε.
TEMPLATE_TEST_CASE("a pack of bodies turns as each does alone", "[library][ch8]",
                   TIMESTEP_ALL_LANES) {
    using L = TestType;
    using Real = typename L::Number;
    const Real eps = std::numeric_limits<Real>::epsilon(), h = Real(1) / 60;
    const double allowed = std::is_same_v<Real, float> ? 0 : 24 * double(eps);
    const auto normal = [] { return std::normal_distribution<double>()(random_engine); };
    const auto compare = [&](const auto& solver, const auto& packed, const auto& one_of) {
        Vector3<L> omega;
        Quaternion<L> q;
        for (int k = 0; k < 3; ++k) omega[k] = made<L>([&] { return 5 * normal(); });
        for (int k = 0; k < 4; ++k) q.coeffs()[k] = made<L>([&] { return normal(); });
        q.coeffs() /= sqrt(q.squaredNorm());
        const Vector3<L> after = after_gyroscopic_torque(solver, packed, q, omega, L(h));
        const Quaternion<L> q2 = turned(q, omega, L(h));
        for (int i = 0; i < L::lanes; ++i) {
            const Quaternion<Real> q1(lane(q.coeffs(), i));
            const Vector3<Real> omega1 = lane(omega, i);
            const Vector3<Real> alone = after_gyroscopic_torque(solver, one_of(i), q1, omega1, h);
            INFO(solver.name << ", lane " << i);
            REQUIRE(double((lane(after, i) - alone).norm()) <= allowed * double(omega1.norm()));
            const Quaternion<Real> alone2 = turned(q1, omega1, h);
            REQUIRE((lane(q2.coeffs(), i) - alone2.coeffs()).norm() <= 8 * eps);
        }
    };
    for (int n = 0; n < 200; ++n) {
        const L a = made<L>([] { return between(0.5, 2); }),
                b = made<L>([] { return between(0.5, 2); });
        const L c = made<L>([] { return between(0.5, 2); });
        const auto all_kinds = [&](const auto& solver) {
            compare(solver, sphere(L(10), a), [&](int i) { return sphere(Real(10), a[i]); });
            compare(solver, capsule(L(10), a, b),
                    [&](int i) { return capsule(Real(10), a[i], b[i]); });
            compare(solver, box(L(10), a, b, c),
                    [&](int i) { return box(Real(10), a[i], b[i], c[i]); });
        };
        all_kinds(no_gyroscopic), all_kinds(explicit_gyroscopic);
        all_kinds(implicit_gyroscopic), all_kinds(passive_gyroscopic);
        all_kinds(half_step_jacobian), all_kinds(cayley_gyroscopic);
    }
}

// As above; a splitting has ten such sums for ω and its attitude five products, one after the other.
TEMPLATE_TEST_CASE("a pack of bodies takes whole-body steps as each does alone", "[library][ch8]",
                   TIMESTEP_ALL_LANES) {
    using L = TestType;
    using Real = typename L::Number;
    const Real h = Real(1) / 60;
    const double allowed = 40 * double(std::numeric_limits<Real>::epsilon());
    const auto normal = [] { return std::normal_distribution<double>()(random_engine); };
    const auto compare = [&](const auto& method, const auto& packed, const auto& one_of) {
        SpinState<L> s1{0, {}, {}};
        for (int k = 0; k < 3; ++k) s1.omega[k] = made<L>([&] { return 5 * normal(); });
        for (int k = 0; k < 4; ++k) s1.q.coeffs()[k] = made<L>([&] { return normal(); });
        s1.q = over_its_length(s1.q);
        const SpinState<L> s2 = method.step(packed, s1, L(h));
        for (int i = 0; i < L::lanes; ++i) {
            const SpinState<Real> one{0, Quaternion<Real>(lane(s1.q.coeffs(), i)),
                                      lane(s1.omega, i)};
            const SpinState<Real> alone = method.step(one_of(i), one, h);
            INFO(method.name << ", lane " << i);
            REQUIRE(double((lane(s2.omega, i) - alone.omega).norm()) <=
                    allowed * double(one.omega.norm()));
            REQUIRE(double((lane(s2.q.coeffs(), i) - alone.q.coeffs()).norm()) <= allowed);
        }
    };
    for (int n = 0; n < 200; ++n) {
        const L a = made<L>([] { return between(0.5, 2); }),
                b = made<L>([] { return between(0.5, 2); });
        const L c = made<L>([] { return between(0.5, 2); });
        const auto of_a_box = [&](const auto& method) {
            compare(method, box(L(10), a, b, c),
                    [&](int i) { return box(Real(10), a[i], b[i], c[i]); });
        };
        of_a_box(tumble<HalfStepJacobian>), of_a_box(tumble<PassiveGyroscopic>);
        of_a_box(tumble<CayleyGyroscopic>), of_a_box(strang);
    }
}

TEST_CASE("a pack refuses what any of its lanes refuses", "[library][ch8]") {
    using L = Lanes<double>;
    const auto with = [](double bad) {
        L all(1);
        all.set(L::lanes - 1, bad);
        return all;
    };
    const double inf = std::numeric_limits<double>::infinity();
    CHECK_NOTHROW(Spring(with(2)));
    CHECK_THROWS_MATCHES(Spring(with(-3)), std::invalid_argument,
                         Message("omega = -3: must be finite and zero or more"));
    CHECK_THROWS_MATCHES(Spring(with(1e200)), std::invalid_argument,
                         Message("omega = 1e+200: must be small enough that its square is finite"));
    CHECK_THROWS_MATCHES(
        DampedSpring(with(1e150), with(1e200)), std::invalid_argument,
        Message("zeta = 1e+200: must be small enough that 2 zeta omega is finite"));
    CHECK_THROWS_MATCHES(UniformInertia(with(0)), std::invalid_argument,
                         Message("moment of inertia = 0: must be finite and greater than zero"));
    CHECK_THROWS_MATCHES(
        PrincipalInertia<L>(L(1), L(1), with(2.5)), std::invalid_argument,
        Message("moment of inertia = 2.5: must be at most the sum of the other two moments"));
    CHECK_THROWS_AS(SymmetricInertia<L>(with(std::nan("")), L(1)), std::invalid_argument);
    CHECK(is_finite(with(0)));
    CHECK_FALSE(is_finite(with(inf)));
}
