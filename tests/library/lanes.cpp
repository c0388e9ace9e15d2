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

#include <timestep/gyroscopic.hpp>
#include <timestep/lanes.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/spring.hpp>

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
double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_engine); }

// What lane `i` of a pack's state or vector holds.
template <class L>
State<typename L::Number> lane(const State<L>& s, int i) {
    return {s.t[i], s.x[i], s.v[i]};
}
template <class Real, int N>
using Loop = Lanes<Real, N, detail::ArrayPack<Real, N>>;  // as where the compiler has no vectors

}  // namespace

#define TIMESTEP_ALL_LANES Lanes<float>, Lanes<double>, (Loop<float, 4>), (Loop<double, 2>)

TEMPLATE_TEST_CASE("a lane computes what one number does, to the last bit", "[library][ch8]", TIMESTEP_ALL_LANES) {
    using L = TestType;
    using Real = typename L::Number;
    for (int n = 0; n < 1000; ++n) {
        const L a = made<L>([] { return between(-3, 3); }), b = made<L>([] { return between(1, 9); });
        L sum = a, difference = a, product = a, quotient = a;
        sum += b, difference -= b, product *= b, quotient /= b;
        const L minus = -a, root = sqrt(b), third = cbrt(a), sine = sin(a), cosine = cos(a);
        const SineCosine<L> both = sine_cosine(a);
        const L mixed = 2 * a + 1 / b - Real(0.5);
        for (int i = 0; i < L::lanes; ++i) {
            REQUIRE(same(sum[i], a[i] + b[i]));
            REQUIRE(same(difference[i], a[i] - b[i]));
            REQUIRE(same(product[i], a[i] * b[i]));
            REQUIRE(same(quotient[i], a[i] / b[i]));
            REQUIRE(same(minus[i], -a[i]));
            REQUIRE(same(root[i], std::sqrt(b[i])));
            REQUIRE(same(third[i], cube_root(a[i])));
            REQUIRE(same(sine[i], sine_cosine(a[i]).sine));
            REQUIRE(same(cosine[i], sine_cosine(a[i]).cosine));
            REQUIRE((same(both.sine[i], sine[i]) && same(both.cosine[i], cosine[i])));
            REQUIRE(same(mixed[i], 2 * a[i] + 1 / b[i] - Real(0.5)));
        }
    }
    const Real inf = std::numeric_limits<Real>::infinity();
    for (const Real value : {Real(0), -Real(0), inf, -inf, std::numeric_limits<Real>::denorm_min()})
        for (int i = 0; i < L::lanes; ++i) REQUIRE(same(L(value)[i], value));
    CHECK(std::isnan(L(std::numeric_limits<Real>::quiet_NaN())[L::lanes - 1]));
}

// What follows is a matter of formulas, not of packs: one kind of pack for `float`, one for
// `double`. (many.cpp steps the other one for `double`.)
#define TIMESTEP_BOTH_REALS Lanes<float>, (Loop<double, 2>)

// One step of every method for a pack and for each of its springs. (A two-step method gets one state twice.)
TEMPLATE_TEST_CASE("every method steps a pack of springs as it steps each, to the last bit", "[library][ch8]",
                   TIMESTEP_BOTH_REALS) {
    using L = TestType;
    using Real = typename L::Number;
    const auto compare = [](const auto& method, const auto& pack, const auto& one_of) {
        const State<L> start{0, made<L>([] { return between(-1, 1); }), made<L>([] { return between(-1, 1); })};
        const auto step = [&](const auto& model, const auto& s, auto h) {
            if constexpr (requires { method.step(model, s, h); })
                return method.step(model, s, h);
            else
                return method.step(model, s, s, h);
        };
        const State<L> end = step(pack, start, L(Real(0.01)));
        for (int i = 0; i < L::lanes; ++i) {
            const State<Real> alone = step(one_of(i), lane(start, i), Real(0.01));
            INFO(method.name << ", lane " << i);
            REQUIRE((same(end.t[i], alone.t) && same(end.x[i], alone.x) && same(end.v[i], alone.v)));
        }
    };
    for (int n = 0; n < 50; ++n) {
        const L omega = made<L>([] { return between(0, 20); }), zeta = made<L>([] { return between(0, 2); });
        const auto damped = [&](int i) { return DampedSpring<Real>(omega[i], zeta[i]); };
        const auto plain = [&](int i) { return Spring<Real>(omega[i]); };
        for_each_method([&](const auto& method) { compare(method, DampedSpring<L>(omega, zeta), damped); });
        for_each_verlet_method([&](const auto& method) { compare(method, Spring<L>(omega), plain); });
    }
}

TEST_CASE("a pack refuses what any of its lanes refuses", "[library][ch8]") {
    using L = Lanes<double>;
    const auto with = [](double bad) {
        L all(1);
        all.set(L::lanes - 1, bad);
        return all;
    };
    CHECK_NOTHROW(Spring(with(2)));
    CHECK_THROWS_MATCHES(Spring(with(-3)), std::invalid_argument,
                         Message("omega = -3: must be finite and zero or more"));
    CHECK_THROWS_MATCHES(Spring(with(1e200)), std::invalid_argument,
                         Message("omega = 1e+200: must be small enough that its square is finite"));
    CHECK_THROWS_AS(DampedSpring(with(1e150), with(1e200)), std::invalid_argument);
    CHECK_THROWS_AS(UniformInertia(with(0)), std::invalid_argument);
    CHECK_THROWS_AS(PrincipalInertia<L>(L(1), L(1), with(2.5)), std::invalid_argument);
    CHECK_THROWS_AS(SymmetricInertia<L>(with(std::nan("")), L(1)), std::invalid_argument);
    CHECK(is_finite(with(0)));
    CHECK_FALSE(is_finite(with(INFINITY)));
}
