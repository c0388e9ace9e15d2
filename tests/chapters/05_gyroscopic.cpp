// The claims of chapter 5 about free bodies: what each way to treat the gyroscopic torque does.

#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <timestep/gyroscopic.hpp>
#include <timestep/measured_order.hpp>
#include <timestep/rigid/shapes.hpp>

#include "exact_free_body.hpp"

using namespace timestep;

namespace {

using V = Vector3<double>;
using Spin = RigidState<double>;

const double h = 1.0 / 60;

Spin spinning(double x, double y, double z) { return {0, Quaternion<double>::Identity(), {x, y, z}}; }

template <class Solver, class Inertia>
Spin after(const Solver& solver, const Inertia& inertia, Spin s, double step, long steps) {
    for (long n = 0; n < steps; ++n) s = step_rotation(solver, inertia, s, step);
    return s;
}

template <class Inertia>
double momentum(const Inertia& inertia, const Spin& s) {
    return angular_momentum(inertia, s).norm();
}

V in_body(const Spin& s) { return s.q.conjugate() * s.omega; }

// The times, to a step, at which the component about the middle axis changes its sign.
template <class Solver>
std::vector<double> flips(const Solver& solver, const PrincipalInertia<double>& inertia, Spin s, double seconds) {
    std::vector<double> at;
    while (s.t < seconds) {
        const double before = in_body(s).y();
        s = step_rotation(solver, inertia, s, h);
        if (before * in_body(s).y() < 0) at.push_back(s.t);
    }
    return at;
}

// Bodies that could exist: moments from how far the mass reaches along three axes.
struct RandomBodies {
    std::mt19937 random{7};
    PrincipalInertia<double> inertia() {
        std::uniform_real_distribution<double> even(-3, 0);
        const double a = std::pow(10, even(random)), b = std::pow(10, even(random)), c = std::pow(10, even(random));
        return {b + c, c + a, a + b};
    }
    V direction() {
        std::normal_distribution<double> normal;
        return V(normal(random), normal(random), normal(random)).normalized();
    }
};

}  // namespace

TEST_CASE("the exact motion obeys Euler's equations", "[N40][ch5]") {
    const auto brick = box(12.0, 1.0, 2.0, 3.0);
    const ExactFreeBody<double> exact(brick, spinning(1, 2, 2));
    for (double t = 0; t < 10; t += 0.37) {
        const V w = in_body(exact(t));
        const V left = brick.momentum(exact.acceleration(t)) + w.cross(brick.momentum(w));
        CHECK(left.norm() < 1e-12 * w.norm() * brick.momentum(w).norm());
    }
}

TEST_CASE("a cube and a ball have no gyroscopic torque, a box has", "[N41][ch5]") {
    const V omega(1, 2, 2);
    CHECK(omega.cross(cube(12.0, 2.0).momentum(omega)).norm() == 0);
    CHECK(omega.cross(sphere(12.0, 1.0).momentum(omega)).norm() == 0);
    // I = (13, 10, 5), L = (13, 20, 10): ω × L = (2·10 − 2·20, 2·13 − 1·10, 1·20 − 2·13).
    CHECK(omega.cross(box(12.0, 1.0, 2.0, 3.0).momentum(omega)) == V(-20, 16, -6));
}

TEST_CASE("a solver without any code steps a ball", "[N41][ch5]") {
    struct Nothing {};
    CHECK(step_rotation(Nothing{}, sphere(1.0, 1.0), spinning(1, 2, 3), h).omega == V(1, 2, 3));
}

TEST_CASE("the orientation of a tumbling box is of order one, its quaternion of length one", "[N42][ch5]") {
    const auto brick = box(12.0, 1.0, 2.0, 3.0);
    const Spin start = spinning(1, 2, 2), end = ExactFreeBody<double>(brick, start)(1);
    std::vector<double> step, error;
    for (const long steps : {1000, 2000, 4000}) {
        const Spin s = after(passive_gyroscopic, brick, start, 1.0 / double(steps), steps);
        CHECK(std::fabs(s.q.norm() - 1) < 8 * 2.3e-16);
        step.push_back(1.0 / double(steps));
        error.push_back((s.q.conjugate() * end.q).vec().norm());
    }
    // The next term of the error is smaller by some h|ω| < 0.003 times a constant of order one.
    CHECK(std::fabs(measured_order(step, error) - 1) < 0.05);
}

TEST_CASE("explicit: a free capsule has a thousand times its energy within seconds", "[N43][ch5]") {
    // Across the axis ω grows by √(1 + θ²) a step, θ = h·precession_ratio·ω_z ≈ 0.27; the part of the energy
    // there is half. A factor of 2000 needs ln 2000/ln(1 + θ²) ≈ 105 steps.
    const auto pill = capsule(1.0, 0.15, 0.6);
    const Spin start = spinning(5, 0, 20);
    CHECK(kinetic_energy(pill, after(explicit_gyroscopic, pill, start, h, 150)) > 1000 * kinetic_energy(pill, start));
}

TEST_CASE("dropped: omega stands still in the world and the momentum swings", "[N44][ch5]") {
    const auto pill = capsule(1.0, 0.15, 0.6);
    const Spin start = spinning(5, 0, 20), end = after(no_gyroscopic, pill, start, h, 600);
    CHECK((end.omega - start.omega).norm() < 8 * 2.3e-16 * 600 * start.omega.norm());
    double swing = 0;
    const V L0 = angular_momentum(pill, start);
    Spin s = start;
    for (int n = 0; n < 60; ++n) {
        s = step_rotation(no_gyroscopic, pill, s, h);
        const V L = angular_momentum(pill, s);
        swing = std::max(swing, std::acos(std::min(1.0, L.dot(L0) / L.norm() / L0.norm())));
    }
    CHECK(swing > 0.5);
}

TEST_CASE("dropped: a thrown staff's axis goes round at |omega| instead of |L|/I", "[N44][ch5]") {
    const auto stick = staff(1.0, 2.0, 0.06);
    const Spin start = spinning(2, 0, 10);
    const double truth = momentum(stick, start) / stick.across, dropped = start.omega.norm();
    CHECK(dropped > 5 * truth);
    // Half a turn about L: the exact tip is on the other side, mirrored in L. Passive follows to
    // within order one: of the 1 m from the middle to the tip, about half of a step's angle
    // h|ω| = 0.17, and of what the tip moves in the half step by which the time is rounded, 0.02 m.
    const double half_turn = 3.141592653589793 / truth;
    const V tip =
        ExactFreeBody<double>(PrincipalInertia<double>(stick.across, stick.across, stick.along), start)(half_turn).q *
        V(V::UnitZ());
    const long steps = std::lround(half_turn / h);
    CHECK((after(passive_gyroscopic, stick, start, h, steps).q * V(V::UnitZ()) - tip).norm() < 0.085 + 0.02);
    CHECK((after(no_gyroscopic, stick, start, h, steps).q * V(V::UnitZ()) - tip).norm() > 1);
}

TEST_CASE("lagged inertia: the momentum stays, the energy does not", "[N45][ch5]") {
    const auto pill = capsule(1.0, 0.15, 0.6);
    const Spin start = spinning(5, 0, 20), end = after(lagged_inertia, pill, start, h, 600);
    CHECK((angular_momentum(pill, end) - angular_momentum(pill, start)).norm() < 1e-10 * momentum(pill, start));
    CHECK(kinetic_energy(pill, end) > 1.5 * kinetic_energy(pill, start));
    // No more than |L|²/2I with the least moment: all of L along the capsule.
    CHECK(kinetic_energy(pill, end) < momentum(pill, start) * momentum(pill, start) / (2 * pill.along) * (1 + 1e-9));
}

TEST_CASE("one iteration solves the residual's tangent", "[N47][ch5]") {
    const PrincipalInertia<double> brick = box(12.0, 1.0, 2.0, 3.0);
    const Matrix3<double> I = brick.moments.asDiagonal();
    const V w(0.3, 0.6, 0.7);
    const V w2 = implicit_gyroscopic.step(brick, w, 1.0);
    const auto residual = [&](const V& at) { return V(I * (at - w) + at.cross(I * at)); };
    // The residual is quadratic: along d it is f + (f(+1) − f(−1))/2 + (f(+1) + f(−1) − 2f)/2, no
    // more.
    const V d = w2 - w, tangent = residual(w) + (residual(w + d) - residual(w - d)) / 2;
    CHECK(tangent.norm() < 1e-14 * I.norm());
}

TEST_CASE("for a capsule one iteration is the converged solution", "[N48][ch5]") {
    const auto pill = capsule(1.0, 0.15, 0.6);
    const V w(5, 3, 60);
    CHECK((implicit_gyroscopic.step(pill, w, h) - converged_gyroscopic.step(pill, w, h)).norm() < 1e-13 * w.norm());
    const PrincipalInertia<double> same(pill.across, pill.across, pill.along);
    CHECK((implicit_gyroscopic.step(pill, w, h) - converged_gyroscopic.step(same, w, h)).norm() < 1e-12 * w.norm());
}

TEST_CASE("one iteration misses the converged solution by the square of h|omega|, squared again", "[N48][ch5]") {
    // Newton-Raphson starts a residual of order h off and squares it twice over: h · h · h in ω.
    const auto brick = box(12.0, 1.0, 2.0, 3.0);
    const V w = V(1, 2, 2) / 3;
    std::vector<double> step, apart;
    for (const double s : {0.02, 0.01, 0.005})
        step.push_back(s),
            apart.push_back((implicit_gyroscopic.step(brick, w, s) - converged_gyroscopic.step(brick, w, s)).norm());
    CHECK(std::fabs(measured_order(step, apart) - 3) < 0.1);
}

TEST_CASE("a box about its intermediate axis: who turns over, and when", "[N50][ch5]") {
    const auto brick = box(1.0, 1.0, 2.0, 3.0);
    const Spin start = spinning(1e-3, 10, 1e-3);
    const ExactFreeBody<double> exact(brick, start);
    std::vector<double> truth;
    for (double t = 0; t < 12; t += 1e-3)
        if (in_body(exact(t)).y() * in_body(exact(t + 1e-3)).y() < 0) truth.push_back(t);
    REQUIRE(truth.size() == 3);
    CHECK(flips(no_gyroscopic, brick, start, 12).empty());
    const auto talk = flips(implicit_gyroscopic, brick, start, 12);
    REQUIRE(talk.size() == truth.size());
    // The tilt grows like e^(σt), σ² = ω²(I₁ − I₂)(I₂ − I₃)/(I₁I₃), and implicit Euler multiplies it
    // by 1/(1 − hσ) a step: early by the share hσ/2 of the time to the first flip. Later flips start
    // from what the last one left. The times are known to a step.
    const V I = brick.moments;
    const double sigma = 10 * std::sqrt((I.x() - I.y()) * (I.y() - I.z()) / (I.x() * I.z()));
    for (std::size_t i = 0; i < truth.size(); ++i) {
        CHECK(talk[i] < truth[i] + h);
        CHECK(talk[i] > truth[i] - h * sigma / 2 * truth[0]);
    }
    CHECK(kinetic_energy(brick, after(implicit_gyroscopic, brick, start, h, 720)) < 0.8 * kinetic_energy(brick, start));
    CHECK(kinetic_energy(brick, after(explicit_gyroscopic, brick, start, h, 720)) > 1.2 * kinetic_energy(brick, start));
}

// From a spin Ω about the middle axis to the plane of the other two, by E and L:
// ω₁² = Ω² I₂(I₂ − I₃)/(I₁(I₁ − I₃)), ω₃² = Ω² I₂(I₁ − I₂)/(I₃(I₁ − I₃)). The tilt adds 1e-6 of it.
TEST_CASE("as a body tumbles, the length of omega rises", "[N50][ch5]") {
    const auto longest = [](double I1, double I2, double I3) {
        const ExactFreeBody<double> exact({I1, I2, I3}, spinning(1e-3, 1, 1e-3));
        double most = 0;
        for (double t = 0; t < 60; t += 0.005) most = std::max(most, exact(t).omega.norm());
        const double squares = I2 * (I2 - I3) / (I1 * (I1 - I3)) + I2 * (I1 - I2) / (I3 * (I1 - I3));
        CHECK(std::fabs(most / std::sqrt(squares) - 1) < 1e-4);
        return most;
    };
    CHECK(longest(13, 10, 5) > 1.1);
    CHECK(longest(1, 0.9, 0.12) > 1.28);
    CHECK(longest(1, 0.99, 0.011) > 1.37);  // √2 is the limit, for a needle
}

TEST_CASE("the passive step ends in a spin about the largest moment", "[N50][N51][ch5]") {
    const auto brick = box(1.0, 1.0, 2.0, 3.0);
    const Spin start = spinning(1e-3, 10, 1e-3);
    const V w = in_body(after(passive_gyroscopic, brick, start, h, 3600)).cwiseAbs();
    CHECK(w.x() > 1e3 * (w.y() + w.z()));
}

TEST_CASE("passive: a long body keeps its spin by its type alone; one iteration keeps it anyway", "[N50][N51][ch5]") {
    const auto pill = capsule(1.0, 0.15, 0.6);
    const Spin start = spinning(0.5, 0, 20);
    const PrincipalInertia<double> uneven(pill.across, 1.02 * pill.across, pill.along),
        even(pill.across, pill.across, pill.along);
    // Where it ends, all of L is about the largest moment, and none of ω along the body.
    CHECK(std::fabs(in_body(after(passive_gyroscopic, uneven, start, h, 600)).z()) < 0.1);
    CHECK(std::fabs(in_body(after(passive_gyroscopic, even, start, h, 600)).z()) < 0.1);
    CHECK(std::fabs(in_body(after(passive_gyroscopic, pill, start, h, 600)).z() - 20) < 1e-9);
    // ω̇_z = −0.11 ω_x ω_y is 0.014 at most, and changes its sign 2 · 16/π times a second as ω goes
    // round: ω_z moves by less than 1e-3, once and a bit until implicit Euler has damped the tilt away.
    CHECK(std::fabs(in_body(after(implicit_gyroscopic, uneven, start, h, 600)).z() - 20) < 0.01);
}

TEST_CASE("one iteration adds energy to a body that could exist; passive and converged do not", "[N51][ch5]") {
    const PrincipalInertia<double> plank(0.758, 0.787, 0.0313);
    const V w(-0.973, -0.137, -0.184);
    const double E = kinetic_energy(plank, w);
    CHECK(kinetic_energy(plank, implicit_gyroscopic.step(plank, w, 1.0)) > 1.7 * E);
    CHECK(kinetic_energy(plank, passive_gyroscopic.step(plank, w, 1.0)) <= E);
    CHECK(kinetic_energy(plank, converged_gyroscopic.step(plank, w, 1.0)) <= E);
}

TEST_CASE("passive: never more energy, never less momentum, whatever the step", "[N51][ch5]") {
    const double epsilon = 2.3e-16;
    RandomBodies bodies;
    for (int n = 0; n < 20000; ++n) {
        const auto inertia = bodies.inertia();
        const V w = bodies.direction(), L = inertia.momentum(w);
        const double size = std::pow(10.0, -3 + 6.0 * (n % 100) / 99);
        const V w2 = passive_gyroscopic.step(inertia, w, size);
        REQUIRE(kinetic_energy(inertia, w2) <= kinetic_energy(inertia, w) * (1 + 8 * epsilon));
        REQUIRE(inertia.momentum(w2).norm() >= L.norm() * (1 - 1e-9));
    }
}

TEST_CASE("among random bodies with h|omega| = 1 some gain by one iteration, with h|omega| = 0.01 none", "[N51][ch5]") {
    RandomBodies bodies;
    int fast = 0, slow = 0;
    for (int n = 0; n < 5000; ++n) {
        const auto inertia = bodies.inertia();
        const V w = bodies.direction();
        const double E = kinetic_energy(inertia, w);
        fast += kinetic_energy(inertia, implicit_gyroscopic.step(inertia, w, 1.0)) > 1.001 * E;
        slow += kinetic_energy(inertia, implicit_gyroscopic.step(inertia, w, 0.01)) > 1.001 * E;
    }
    CHECK(fast > 100);
    CHECK(slow == 0);
}
