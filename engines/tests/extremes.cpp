// The functions for C at the edges of what numbers can hold: what is finite stays finite.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "c_functions.hpp"
#include "random_inertia.hpp"

using namespace timestep;

namespace {

// In long double, which holds the squares of any double.
template <class Real>
long double energy(const Body<Real>& body, const Vector3<Real>& w) {
    long double sum = 0;
    for (int i = 0; i < 3; ++i) sum += static_cast<long double>(body.unit[i]) * w[i] * w[i];
    return sum / 2;
}
template <class Real>
long double momentum(const Body<Real>& body, const Vector3<Real>& w) {
    long double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const long double L = static_cast<long double>(body.unit[i]) * w[i];
        sum += L * L;
    }
    return std::sqrt(sum);
}

// All that a function may be handed: from the smallest number to the largest.
template <class Real>
std::vector<Real> numbers() {
    using Numbers = std::numeric_limits<Real>;
    return {0,          Numbers::denorm_min(), Numbers::min(), Real(1e-25), Real(1e-3), 1, Real(1e6), Real(1e20),
            Real(3e24), Numbers::max()};
}

template <class Real, class Look>
void for_each_body(const Look& look) {
    std::vector<Real> moments = numbers<Real>();
    moments.push_back(-1);
    moments.push_back(std::numeric_limits<Real>::infinity());
    for (const Real a : moments)
        for (const Real b : moments)
            for (const Real c : moments) {
                INFO("moments " << a << ", " << b << ", " << c);
                look(functions<Real>().from_moments(a, b, c));
                look(functions<Real>().from_inverse_moments(a, b, c));
            }
    INFO("a needle");
    look(functions<Real>().from_moments(1, Real(0.9999999), Real(1e-12)));
    look(functions<Real>().from_moments(Real(0.3), Real(0.4), Real(0.5)));
}

}  // namespace

TEMPLATE_TEST_CASE("in C finite input gives finite output", "[c]", float, double) {
    using Vec = Vector3<TestType>;
    const std::vector<TestType> all = numbers<TestType>();
    std::vector<Vec> spins;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) spins.emplace_back(all[i], -all[j], all[(i + j) / 2]);
    const Quaternion<TestType> orientations[] = {
        {1, 0, 0, 0}, Quaternion<TestType>(1, TestType(0.2), -3, 2).normalized(), {0, 0, 0, 0}};
    for_each_body<TestType>([&](const Body<TestType>& body) {
        for (const Vec& w : spins)
            for (const TestType size : {TestType(0), TestType(1e-30), TestType(0.02), TestType(1), TestType(1e30),
                                        std::numeric_limits<TestType>::max()})
                for (const TestType h : {size, -size}) {
                    bool finite = true;
                    for (int i = 0; i < 3; ++i) {
                        Vec after = w;
                        functions<TestType>().rule[i](&body, after.data(), h);
                        finite = finite && after.allFinite();
                    }
                    const auto& q = orientations[std::size_t(std::abs(w.x()) < 1 ? 0 : h > 0 ? 1 : 2)];
                    for (int i = 0; i < 3; ++i) {
                        Vec after = w;
                        functions<TestType>().rule_in_world[i](&body, q.coeffs().data(), after.data(), h);
                        finite = finite && after.allFinite();
                    }
                    for (int i = 0; i < 2; ++i) {
                        Vec after = w;
                        Quaternion<TestType> turned = q;
                        functions<TestType>().fly[i](&body, turned.coeffs().data(), after.data(), h);
                        finite = finite && after.allFinite() && turned.coeffs().allFinite();
                        after = w, turned = q;
                        functions<TestType>().fly_in_world[i](&body, turned.coeffs().data(), after.data(), h);
                        finite = finite && after.allFinite() && turned.coeffs().allFinite();
                    }
                    finite = finite && functions<TestType>().half_step_limit(&body, w.data()) > 0;
                    finite = finite && std::isfinite(functions<TestType>().fastest(&body, w.data()));
                    INFO("w = " << w.transpose() << ", h = " << h);
                    if (!finite) FAIL("not finite");
                }
    });
}

// To the world and back numbers grow by √3 at most.
TEMPLATE_TEST_CASE("in C the rules give finite output near the largest numbers, too, in the body and in the world",
                   "[c]", float, double) {
    using Vec = Vector3<TestType>;
    RandomInertia random(9);
    std::mt19937 numbers(9);
    std::normal_distribution<double> normal;
    int changed = 0;
    for (int n = 0; n < 20000; ++n) {
        const auto I = random.inertia<TestType>(10);
        const TestType across = I.moments.x(), along = std::min(I.moments.y(), 2 * across);
        Vec w = random.direction<TestType>();
        w = w / w.cwiseAbs().maxCoeff() * std::numeric_limits<TestType>::max();
        for (int i = 0; i < 3; ++i)
            if ((n >> i) % 2) w[i] /= 2;
        if (n % 3 == 0) w[n % 2] = 1;
        Quaternion<TestType> q(TestType(normal(numbers)), TestType(normal(numbers)), TestType(normal(numbers)),
                               TestType(normal(numbers)));
        q.normalize();
        // So short that ω turns by a few radians at most.
        const TestType h = TestType(normal(numbers)) / std::numeric_limits<TestType>::max();
        for (const auto& body : {functions<TestType>().from_moments(I.moments.x(), I.moments.y(), I.moments.z()),
                                 functions<TestType>().from_moments(across, across, along),
                                 functions<TestType>().from_moments(across, along, across),
                                 functions<TestType>().from_moments(along, across, across)}) {
            CAPTURE(I.moments, w, q.coeffs(), h, body.kind, body.odd);
            bool finite = std::isfinite(functions<TestType>().fastest(&body, w.data()));
            for (int i = 0; i < 3; ++i) {
                Vec after = w, world = w;
                functions<TestType>().rule[i](&body, after.data(), h);
                functions<TestType>().rule_in_world[i](&body, q.coeffs().data(), world.data(), h);
                finite = finite && after.allFinite() && world.allFinite();
                changed += after != w || world != w;
            }
            if (!finite) FAIL("not finite");
        }
    }
    CHECK(changed > 1000);
}

// Roundoff: a few ε a part of the step, of which there are 32 at most, and each passive step rounds its energy some ten
// times.
TEMPLATE_TEST_CASE("in C the passive step never adds energy and the calm one keeps it, at any spin", "[c]", float,
                   double) {
    using Vec = Vector3<TestType>;
    const TestType epsilon = std::numeric_limits<TestType>::epsilon();
    RandomInertia random(5);
    for (int n = 0; n < 2000; ++n) {
        const auto I = random.inertia<TestType>(1000);
        const auto body = functions<TestType>().from_moments(I.moments.x(), I.moments.y(), I.moments.z());
        const Vec direction = random.direction<TestType>();
        for (const double size : {1e-20, 1e-3, 1.0, 1e3, 1e7, 1e12, 1e20}) {
            const Vec w = TestType(size) * direction;
            INFO("I = " << I.moments.transpose() << ", w = " << w.transpose());
            for (const TestType h : {TestType(0.01), TestType(1)}) {
                Vec passive = w, calm = w;
                functions<TestType>().rule[0](&body, passive.data(), h);
                functions<TestType>().rule[2](&body, calm.data(), h);
                REQUIRE(energy(body, passive) <= energy(body, w) * (1 + 32 * epsilon));
                REQUIRE(std::fabs(energy(body, calm) / energy(body, w) - 1) <= 32 * 8 * epsilon);
                REQUIRE(std::fabs(momentum(body, calm) / momentum(body, w) - 1) <= 32 * 8 * epsilon);
            }
        }
    }
}

TEMPLATE_TEST_CASE("in C an axis that is locked leaves the spin as it is", "[c]", float, double) {
    using Vec = Vector3<TestType>;
    const TestType none = std::numeric_limits<TestType>::infinity();
    const Quaternion<TestType> q = Quaternion<TestType>(1, 2, 3, 4).normalized();
    std::vector<Body<TestType>> bodies;
    for (const TestType locked : {TestType(0), none, TestType(-1), std::numeric_limits<TestType>::min() / 2,
                                  std::numeric_limits<TestType>::quiet_NaN()}) {
        bodies.push_back(functions<TestType>().from_moments(locked, 1, 2));
        bodies.push_back(functions<TestType>().from_moments(1, locked, 2));
        bodies.push_back(functions<TestType>().from_moments(1, 2, locked));
        bodies.push_back(functions<TestType>().from_moments(locked, locked, locked));
    }
    std::feclearexcept(FE_DIVBYZERO);
    bodies.push_back(functions<TestType>().from_inverse_moments(0, 1, 2));
    CHECK(!std::fetestexcept(FE_DIVBYZERO));  // which some engines trap
    bodies.push_back(functions<TestType>().from_inverse_moments(1, 0, 2));
    bodies.push_back(functions<TestType>().from_inverse_moments(1, 2, 0));
    bodies.push_back(functions<TestType>().from_inverse_moments(0, 0, 0));
    bodies.push_back(functions<TestType>().from_moments(3, 3, 3));  // and so does a ball
    const Vec w(1, -2, 3);
    for (const auto& body : bodies) {
        CHECK(functions<TestType>().idle(&body, w.data()));
        for (int i = 0; i < 3; ++i) {
            Vec after = w, world = w;
            functions<TestType>().rule[i](&body, after.data(), 1);
            functions<TestType>().rule_in_world[i](&body, q.coeffs().data(), world.data(), 1);
            CHECK(after == w);
            CHECK(world == w);
        }
        for (int i = 0; i < 2; ++i) {  // the orientation turns with it
            Vec after = w, world = w;
            Quaternion<TestType> turned = q, turned_in_world = q;
            functions<TestType>().fly[i](&body, turned.coeffs().data(), after.data(), 1);
            functions<TestType>().fly_in_world[i](&body, turned_in_world.coeffs().data(), world.data(), 1);
            CHECK(after == w);
            CHECK(world == w);
            CHECK(apart(turned, Quaternion<TestType>(q * rotation_by(w))) <
                  32 * std::numeric_limits<TestType>::epsilon());
            CHECK(apart(turned_in_world, Quaternion<TestType>(rotation_by(w) * q)) <
                  32 * std::numeric_limits<TestType>::epsilon());
        }
    }
}

TEMPLATE_TEST_CASE("in C nothing changes for h = 0, for omega = 0, and about a principal axis", "[c]", float, double) {
    using Vec = Vector3<TestType>;
    const auto box = functions<TestType>().from_moments(1, 2, TestType(2.5)),
               pill = functions<TestType>().from_moments(1, TestType(0.3), 1);
    const auto stays = [&](const Body<TestType>& body, const Vec& w, TestType h) {
        for (int i = 0; i < 3; ++i) {
            Vec after = w;
            functions<TestType>().rule[i](&body, after.data(), h);
            CHECK(after == w);
        }
        for (int i = 0; i < 2; ++i) {
            Vec after = w;
            Quaternion<TestType> q(1, 0, 0, 0);
            functions<TestType>().fly[i](&body, q.coeffs().data(), after.data(), h);
            if (h == 0)
                CHECK((after - w).norm() <= 4 * std::numeric_limits<TestType>::epsilon() * w.norm());  // to L and back
            else
                CHECK(after == w);
        }
    };
    stays(box, Vec(1, 2, 3), 0);
    stays(pill, Vec(1, 2, 3), 0);
    stays(box, Vec(0, 0, 0), 1);
    for (const TestType spin : {TestType(0.1), TestType(-0.7), TestType(1.3), TestType(30)})
        for (int i = 0; i < 3; ++i) stays(box, spin * Vec::Unit(i), 1);
    stays(pill, Vec(TestType(0.1), 0, TestType(0.7)), 1);  // any axis across
    CHECK(!functions<TestType>().idle(&box, Vec(1, 1, 0).eval().data()));
    CHECK(!functions<TestType>().idle(&pill, Vec(1, 1, 0).eval().data()));
}

TEMPLATE_TEST_CASE("in C a spin that is no number or infinite comes back as it was", "[c]", float, double) {
    using Vec = Vector3<TestType>;
    const Quaternion<TestType> q = Quaternion<TestType>(1, 2, 3, 4).normalized();
    const auto stays = [&](const auto& step, const Vec& w) {
        Vec after = w;
        Quaternion<TestType> turned = q;
        step(turned.coeffs().data(), after.data());
        CHECK(turned.coeffs() == q.coeffs());
        for (int i = 0; i < 3; ++i) CHECK((after[i] == w[i] || (std::isnan(after[i]) && std::isnan(w[i]))));
    };
    for (const TestType none : {std::numeric_limits<TestType>::quiet_NaN(), std::numeric_limits<TestType>::infinity(),
                                -std::numeric_limits<TestType>::infinity()})
        for (const auto& body :
             {functions<TestType>().from_moments(13, 10, 5), functions<TestType>().from_moments(1, 1, TestType(0.3)),
              functions<TestType>().from_moments(1, TestType(0.3), 1),
              functions<TestType>().from_moments(TestType(0.3), 1, 1), functions<TestType>().from_moments(3, 3, 3),
              functions<TestType>().from_moments(0, 1, 2)})
            for (int axis = 0; axis < 3; ++axis)
                for (const Vec& others : {Vec(1, 2, 3), Vec(0, 0, 0)}) {
                    Vec w = others;
                    w[axis] = none;
                    CAPTURE(none, body.kind, body.odd, w);
                    for (const TestType h : {TestType(1) / 60, TestType(-1), TestType(1e7)}) {
                        for (int i = 0; i < 3; ++i) {
                            stays([&](auto*, auto* omega) { functions<TestType>().rule[i](&body, omega, h); }, w);
                            stays(
                                [&](auto* orientation, auto* omega) {
                                    functions<TestType>().rule_in_world[i](&body, orientation, omega, h);
                                },
                                w);
                        }
                        for (int i = 0; i < 2; ++i) {
                            stays([&](auto* orientation,
                                      auto* omega) { functions<TestType>().fly[i](&body, orientation, omega, h); },
                                  w);
                            stays(
                                [&](auto* orientation, auto* omega) {
                                    functions<TestType>().fly_in_world[i](&body, orientation, omega, h);
                                },
                                w);
                        }
                    }
                }
}

// Moments in any unit: scaled by a power of two they are the same body. (The scales are the largest and smallest that
// leave all of them normal numbers, to 1e-38; a millimetre and a milligram come to 1e-12.)
TEST_CASE("in C a body of any size is the same body, in float", "[c]") {
    const Vector3<float> w(3, 20, -5);
    const auto brother = functions<float>().from_moments(0.3f, 0.41f, 0.52f);
    for (const int power : {-124, -120, -81, -40, -20, 20, 60, 81, 120, 126}) {
        const float moments[] = {std::ldexp(0.3f, power), std::ldexp(0.41f, power), std::ldexp(0.52f, power)};
        const auto body = functions<float>().from_moments(moments[0], moments[1], moments[2]);
        const int upwards = std::min(power, 123);  // one over them is normal, too
        const auto inverse = functions<float>().from_inverse_moments(
            std::ldexp(1 / 0.3f, upwards), std::ldexp(1 / 0.41f, upwards), std::ldexp(1 / 0.52f, upwards));
        for (int i = 0; i < 3; ++i) {
            Vector3<float> after = w, expected = w, by_inverse = w;
            functions<float>().rule[i](&body, after.data(), 1 / 60.0f);
            functions<float>().rule[i](&brother, expected.data(), 1 / 60.0f);
            functions<float>().rule[i](&inverse, by_inverse.data(), 1 / 60.0f);
            INFO("2^" << power << ", rule " << i);
            CHECK((expected - w).norm() > 0.05f);
            CHECK((after - expected).norm() < 16 * std::numeric_limits<float>::epsilon() * w.norm());
            CHECK((by_inverse - expected).norm() < 16 * std::numeric_limits<float>::epsilon() * w.norm());
        }
    }
}

// 1 − (a₀ ω₂)(a₂ ω₂) with all its factors rounded: of neighbouring spins some give zero.
TEST_CASE("in C a half step whose equations have no solution leaves the spin as it is", "[c]") {
    const PrincipalInertia<float> I(1, 1.3f, 1.9f);
    const auto body = functions<float>().from_moments(1, 1.3f, 1.9f);
    const float root = std::sqrt(I.ratio.x() * I.ratio.z());
    int singular = 0;
    for (float h = 0.5f; h <= 1; h += 0.01f) {
        Vector3<float> w(1e-10f, 2 / root / h * (1 - 4 * std::numeric_limits<float>::epsilon()), 1e-10f);
        for (int n = 0; n < 20; ++n) {
            Vector3<float> after = w;
            functions<float>().rule[1](&body, after.data(), h);
            if (!half_step_jacobian.step(I, w, h).allFinite()) {
                ++singular;
                CHECK(after == w);
            }
            w.y() = std::nextafter(w.y(), 100.0f);
        }
    }
    CHECK(singular > 0);
}

TEST_CASE("in C a spin of 1e20 is neither lost nor infinite in float, and one of 1e-25 keeps its bits", "[c]") {
    const auto body = functions<float>().from_moments(1, 2, 2.5f);
    for (int i = 0; i < 3; ++i) {
        const Vector3<float> tiny(1e-25f, 2e-25f, -1e-25f), huge(1e20f, 2e20f, -1e20f);
        Vector3<float> after = tiny;
        functions<float>().rule[i](&body, after.data(), 1 / 60.0f);
        CHECK(after == tiny);
        after = huge;
        functions<float>().rule[i](&body, after.data(), 1 / 60.0f);
        CHECK(after.allFinite());
        if (i != 1) CHECK(after.cwiseAbs().maxCoeff() > 1e19f);  // the half step promises nothing there
    }
    // A tiny spin in a huge step is one like any other.
    Vector3<float> one(1, 2, -1), tiny = std::ldexp(1.0f, -83) * one;
    functions<float>().rule[2](&body, one.data(), 0.25f);
    functions<float>().rule[2](&body, tiny.data(), std::ldexp(0.25f, 83));
    CHECK(Vector3<float>(std::ldexp(1.0f, 83) * tiny) == one);
}
