// The claims of chapter 5 about bodies that something acts on: contacts, friction, rolling
// resistance and motors around the gyroscopic torque.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <timestep/measured_order.hpp>

#include "chapters/05_gyroscopic/study/plane_scene.hpp"

using namespace timestep;
using plane::Arms;
using plane::Contacts;
using plane::V;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double h = 1.0 / 60;

template <class Solver, class Inertia, class Look>
plane::BodyState run(const Solver& solver, const plane::Capsule<Inertia>& body, const plane::Ground& ground,
                     plane::BodyState m, long steps, const Look& look, double step_length = h) {
    Contacts contacts;
    for (long n = 0; n < steps; ++n) {
        const plane::BodyState before = m;
        m = plane::step(solver, body, ground, m, step_length, contacts);
        if (!look(before, m, contacts)) break;
    }
    return m;
}

const auto to_the_end = [](const auto&...) { return true; };
bool at_rest(const plane::BodyState& m) { return m.turning.omega.norm() < 1e-3 && m.v.norm() < 1e-3; }

// The time at which it lies still, −1 if that does not happen within 20 s.
template <class Solver>
double rest(const Solver& solver, Arms arms, double step_length = h) {
    const auto body = scene::capsule();
    const auto end = run(
        solver, body, scene::ground(0.1, arms), scene::thrown(body), std::lround(20 / step_length),
        [](const auto&, const auto& m, const Contacts&) { return !at_rest(m); }, step_length);
    return at_rest(end) ? end.turning.t : -1;
}

}  // namespace

TEST_CASE("a step turns a point about the middle between its old and its new place", "[N42][N46][ch5]") {
    // e₂ − e = h ω × (e + e₂)/2: what makes the gap at the end of a step linear in the velocities.
    // All of it is of size h|ω||e| < 20, and some ten roundings.
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
    for (int i = 0; i < 1000; ++i) {
        const Quaternion<double> q = Quaternion<double>(number(), number(), number(), 1).normalized();
        const V omega(2000 * number(), 2000 * number(), 2000 * number()), e(0, 0, 1);
        const V before = q * e, after = rotated(q, omega, h) * e;
        REQUIRE((after - before - h * omega.cross((before + after) / 2)).norm() < 20 * 16 * eps);
    }
}

TEST_CASE("the capsule does not sink into the plane", "[N49][ch5]") {
    const auto body = scene::capsule();
    std::mt19937 random(2);
    double sunk_start = 0, sunk_middle = 0;
    for (int i = 0; i < 12; ++i) {
        const auto start = scene::random_throw(body, random);
        for (const Arms arms : {Arms::start, Arms::middle})
            run(passive_gyroscopic, body, scene::ground(0.1, arms), start, 600,
                [&](const auto&, const auto& m, const Contacts& contacts) {
                    (arms == Arms::start ? sunk_start : sunk_middle) =
                        std::max(arms == Arms::start ? sunk_start : sunk_middle, contacts.sunk);
                    for (int k = 0; k < 2; ++k)  // lifted to the plane: three roundings of a metre
                        REQUIRE(m.x.z() + body.end(m.turning.q, k).z() - body.radius > -4 * eps);
                    // With the old arm the end goes h ω × e, and turns by a chord more or less:
                    // |h ω × (e₂ − e)|/2 ≤ (h|ω|)² |e|/2. What twelve rounds leave open is allowed
                    // a hundredth of that and a tenth of a millimetre.
                    const double chord = h * m.turning.omega.norm();
                    if (arms == Arms::start)
                        REQUIRE(contacts.sunk <= 1.01 * chord * chord * body.half_length / 2 + 1e-4);
                    return true;
                });
    }
    // What the middle arm leaves is the last pass's change of ω: a hundredth of the radius is a
    // millimetre and a half, and no eye sees it.
    CHECK(sunk_middle < 0.01 * body.radius);
    CHECK(sunk_start > 0.01 * body.radius);
}

TEST_CASE("friction, rolling resistance and the passive step bring the capsule to rest", "[N49][ch5]") {
    for (const Arms arms : {Arms::start, Arms::middle}) {
        const double fine = rest(passive_gyroscopic, arms, h / 32);
        const double passive = rest(passive_gyroscopic, arms), implicit = rest(implicit_gyroscopic, arms);
        CHECK(fine > 0);
        // The throw is wild, so no step of 60 Hz follows it closely. Half and double of the time
        // are what a player would not notice.
        CHECK(passive > fine / 2);
        CHECK(passive < fine * 2);
        CHECK(implicit > fine / 2);
        CHECK(implicit < fine * 2);
        CHECK(rest(converged_gyroscopic, arms) == implicit);  // symmetric: one iteration is the solution
    }
}

TEST_CASE("the dropped torque is stable, and the capsule stands up and spins", "[N44][N49][ch5]") {
    const auto body = scene::capsule();
    const plane::Ground ground = scene::ground(0.1, Arms::start);
    const auto start = scene::thrown(body);
    const double first = energy(body, ground, start);
    const auto end = run(no_gyroscopic, body, ground, start, 20 * 60, [&](const auto&, const auto& m, const Contacts&) {
        REQUIRE(energy(body, ground, m) <= first);
        return true;
    });
    CHECK(end.turning.omega.norm() > scene::spin / 2);
    // Upright: the axis within ten degrees of the vertical, where the real one has long been lying.
    CHECK(std::fabs((end.turning.q * V::UnitZ()).z()) > std::cos(0.17));
    // The arms in the middle bring it down, but later than they do the passive one.
    const double dropped = rest(no_gyroscopic, Arms::middle);
    CHECK(dropped > 1.5 * rest(passive_gyroscopic, Arms::middle));
}

TEST_CASE("the explicit torque blows the capsule up on the plane too", "[N43][ch5]") {
    // One step multiplies the part of ω across the axis by √(1 + θ²), θ = h precession_ratio ω_z: here 7 %
    // each sixtieth of a second, against which the plane takes what it can.
    const auto body = scene::capsule();
    for (const Arms arms : {Arms::start, Arms::middle}) {
        double most = 0;
        run(explicit_gyroscopic, body, scene::ground(0.1, arms), scene::thrown(body), 20 * 60,
            [&](const auto&, const auto& m, const Contacts&) {
                const double spin = m.turning.omega.norm();
                most = std::isfinite(spin) ? std::max(most, spin) : std::numeric_limits<double>::infinity();
                return most < 1000;
            });
        CHECK(most >= 1000);
    }
}

TEST_CASE("the lagged inertia makes the capsule on the plane spin faster", "[N45][ch5]") {
    const auto body = scene::capsule();
    const auto end =
        run(lagged_inertia, body, scene::ground(0.1, Arms::start), scene::thrown(body), 20 * 60, to_the_end);
    CHECK(end.turning.omega.norm() > scene::spin);
}

TEST_CASE("with arms in the middle a step adds no energy, with those of its start it does", "[N46][ch5]") {
    const auto body = scene::capsule();
    std::mt19937 random(5);
    int gained_start = 0;
    for (int i = 0; i < 20; ++i) {
        const auto start = scene::random_throw(body, random);
        for (const Arms arms : {Arms::start, Arms::middle}) {
            const plane::Ground ground = scene::ground(0.1, arms);
            const double first = energy(body, ground, start);
            double most = 0;
            run(passive_gyroscopic, body, ground, start, 600, [&](const auto&, const auto& m, const Contacts&) {
                most = std::max(most, energy(body, ground, m) / first);
                return !at_rest(m);
            });
            if (arms == Arms::middle)
                CHECK(most <= 1);
            else
                gained_start += most > 1;
        }
    }
    CHECK(gained_start > 0);
}

TEST_CASE("a ball on the plane moves alike whatever is done to its torque", "[N41][ch5]") {
    const auto ball = scene::ball();
    const auto start = scene::thrown(ball);
    const auto one = run(no_gyroscopic, ball, scene::ground(0.1), start, 300, to_the_end);
    const auto other = run(passive_gyroscopic, ball, scene::ground(0.1), start, 300, to_the_end);
    CHECK(one.x == other.x);
    CHECK(one.turning.omega == other.turning.omega);
    CHECK(one.turning.q.coeffs() == other.turning.q.coeffs());
}

TEST_CASE("a motor explicitly and the gyroscopic torque by its solver: order one", "[N46][ch5]") {
    const PrincipalInertia<double> inertia = box(1.0, 1.0, 2.0, 3.0);
    const auto motor = [](double t) { return V(3 * std::cos(2 * t), 3 * std::sin(3 * t), 1.5); };
    const auto after = [&](const auto& solver, long rate) {
        RigidState<double> s{0, Quaternion<double>::Identity(), V(1, 2, 2)};
        for (long n = 0; n < rate / 2; ++n)
            s = step_rotation(solver, inertia, s, motor(s.t), 1.0 / static_cast<double>(rate));
        return s;
    };
    // Half a second. The reference: explicit steps, extrapolated three times to h = 0, so of order
    // 4 in 1/7680: far below the errors of 1/1920 looked at here.
    std::vector<V> row;
    for (const long rate : {7680, 15360, 30720, 61440}) row.push_back(after(explicit_gyroscopic, rate).omega);
    for (int power = 2; power <= 8; power *= 2) {
        for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = (power * row[i + 1] - row[i]) / (power - 1);
        row.pop_back();
    }
    const V exact = row[0];
    const auto order = [&](const auto& solver) {
        std::vector<double> steps, errors;
        for (const long rate : {480, 960, 1920}) {
            steps.push_back(1.0 / static_cast<double>(rate));
            errors.push_back((after(solver, rate).omega - exact).norm());
        }
        return measured_order(steps, errors);
    };
    // error = C h + D h² with D/C of the order of the rates here, some 10 per second: within
    // 10/480.
    CHECK(std::fabs(order(implicit_gyroscopic) - 1) < 0.04);
    CHECK(std::fabs(order(converged_gyroscopic) - 1) < 0.04);
    CHECK(std::fabs(order(passive_gyroscopic) - 1) < 0.04);
    CHECK(std::fabs(order(no_gyroscopic)) < 0.04);  // not a method for this motion
}
