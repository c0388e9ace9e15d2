// Dampers solved one after another, there and back: what the sweep is, that it is stable, what it refuses.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Core>

#include <timestep/damper_sweep.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>

using namespace timestep;
using Catch::Matchers::Message;
using Eigen::Vector2d;
using Matrix = Eigen::Matrix<double, 10, 10>;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Dampers between masses in a plane.
struct Network {
    std::vector<double> inverse_masses;
    struct Part {
        std::size_t a, b;
        Vector2d along;
        double c;
    };
    std::vector<Part> parts;

    DamperSweep<Vector2d> sweep() const {
        DamperSweep<Vector2d> all(inverse_masses);
        for (const Part& part : parts) all.add(part.a, part.b, part.along, part.c);
        return all;
    }
    // The matrix of a step of 0.1 s with five masses, in u = √m v, column by column. No mass is held here.
    Matrix swept() const {
        auto all = sweep();
        Matrix D;
        for (int i = 0; i < 10; ++i) {
            std::vector<Vector2d> v(5, Vector2d::Zero());
            v[std::size_t(i / 2)][i % 2] = std::sqrt(inverse_masses[std::size_t(i / 2)]);
            all.there_and_back(v, 0.1);
            for (int n = 0; n < 5; ++n)
                D.block<2, 1>(2 * n, i) = v[std::size_t(n)] / std::sqrt(inverse_masses[std::size_t(n)]);
        }
        return D;
    }
    // The inverse of one matrix for all dampers: D⁻¹ = 1 + h Σ c g gᵀ.
    Matrix inverse_of_one_matrix() const {
        Matrix sum = Matrix::Identity();
        for (const Part& part : parts) {
            Eigen::Matrix<double, 10, 1> g = Eigen::Matrix<double, 10, 1>::Zero();
            g.segment<2>(2 * int(part.a)) = std::sqrt(inverse_masses[part.a]) * part.along.normalized();
            g.segment<2>(2 * int(part.b)) = -std::sqrt(inverse_masses[part.b]) * part.along.normalized();
            sum += 0.1 * part.c * g * g.transpose();
        }
        return sum;
    }
};

// Five masses of 0.1 to 10 kg, each pair tied twice in a random direction; dampers from soft to hard.
Network random_network(std::mt19937& random) {
    const auto from = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Network net;
    for (std::size_t i = 0; i < 5; ++i) net.inverse_masses.push_back(std::pow(10, from(-1, 1)));
    for (std::size_t a = 0; a < 5; ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (int n = 0; n < 2; ++n)
                net.parts.push_back({a, b, Vector2d(from(-1, 1), from(-1, 1)), std::pow(10, from(-1, 6))});
    return net;
}

// Whether the 2³⁰-th power is large: an eigenvalue is outside ±1.
bool grows(Matrix power) {
    for (int n = 0; n < 30; ++n) power = power.lazyProduct(power).eval();
    return !(power.norm() < 10);
}

}  // namespace

TEMPLATE_TEST_CASE("one damper there and back is semi-implicit Euler with new damping, to roundoff", "[library][ch3]",
                   float, double) {
    using Real = TestType;
    for (const Real zeta : {Real(0), Real(1e-4), Real(0.1), Real(1), Real(30), Real(1e6)}) {
        const Real omega = 50, h = Real(1) / 60, m = 3;
        const State<Real> one{0, Real(0.3), Real(-7)};
        const State<Real> two = semi_implicit_euler_new_damping.step(DampedSpring<Real>(omega, zeta), one, h);
        DamperSweep<Real> sweep({1 / m, 0});
        sweep.add(0, 1, Real(-2), 2 * zeta * omega * m);
        std::vector<Real> v{one.v - h * omega * omega * one.x, 0};
        sweep.there_and_back(v, h);
        // Some ten roundings, of a number that may be as small as what the roots leave of the velocity.
        CHECK(std::fabs(v[0] / two.v - 1) <
              20 * std::numeric_limits<Real>::epsilon() * std::sqrt(1 + 2 * zeta * omega * h));
        CHECK(v[1] == 0);
    }
}

TEST_CASE("the sweep there and back is symmetric, with eigenvalues between 0 and 1", "[library][ch3]") {
    std::mt19937 random(1);
    for (int n = 0; n < 100; ++n) {
        const Matrix D = random_network(random).swept();
        CHECK((D - D.transpose()).cwiseAbs().maxCoeff() < 1000 * eps);
        CHECK_FALSE(grows(D));
        CHECK_FALSE(grows(Matrix::Identity() - D));
    }
}

TEST_CASE("dampers that are perpendicular or share no mass are one system there and back, to roundoff",
          "[library][ch3]") {
    const Network net{{1, 0.3, 2, 5, 0.7},
                      {{0, 1, Vector2d(1, 2), 70}, {0, 2, Vector2d(-2, 1), 3e4}, {3, 4, Vector2d(3, 1), 500}}};
    const Matrix one = net.swept().lazyProduct(net.inverse_of_one_matrix());
    CHECK((one - Matrix::Identity()).cwiseAbs().maxCoeff() < 1e4 * 20 * eps);
}

// A hub and twelve masses round it, in a plane, each held to its neighbours by springs with a damper beside each. ωh is
// 0.5, and the wheel turns by 0.2 rad per step. Its most energy in 6000 steps, over the first.
static double most_energy_of_a_wheel(double damping) {
    const double pi = std::numbers::pi;
    std::vector<Vector2d> x{Vector2d(0, 0)}, v;
    for (int i = 0; i < 12; ++i) x.push_back(Vector2d(std::cos(i * pi / 6), std::sin(i * pi / 6)));
    for (const Vector2d& each : x) v.push_back(0.2 * Vector2d(-each.y(), each.x()));
    Network wheel{std::vector<double>(13, 1.0), {}};
    for (std::size_t i = 1; i <= 12; ++i)
        for (const std::size_t other : {std::size_t(0), i % 12 + 1})
            wheel.parts.push_back({other, i, x[i] - x[other], damping});
    const double k = 0.25 / 7.0382366;  // the fastest oscillation of springs of 1 N/m has ω² = 7.0382366
    auto sweep = wheel.sweep();
    double first = 0, most = 0;
    for (int n = 0; n <= 6000; ++n) {
        double energy = 0;
        for (const Vector2d& each : v) energy += each.squaredNorm() / 2;
        for (std::size_t i = 0; i < wheel.parts.size(); ++i) {
            const auto& [a, b, along, c] = wheel.parts[i];
            const Vector2d apart = x[b] - x[a];
            const double longer = apart.norm() - along.norm();
            energy += k * longer * longer / 2;
            v[a] += k * longer * apart.normalized(), v[b] -= k * longer * apart.normalized();
            sweep.redirect(i, apart);
        }
        if (n == 0) first = energy;
        most = std::max(most, energy / first);
        sweep.there_and_back(v, 1);
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += v[i];
    }
    return most;
}
TEST_CASE("a wheel of springs that turns: dampers whose hc/m adds up to 1 at the hub add no energy, those of 1 each do",
          "[library][ch3]") {
    const double without = most_energy_of_a_wheel(0);
    CHECK(without < 1.1);
    CHECK(most_energy_of_a_wheel(1.0 / 12) <= without);
    CHECK(most_energy_of_a_wheel(1) > 10);
}

TEST_CASE("dampers keep the momentum, and a held mass its velocity", "[library][ch3]") {
    DamperSweep<Vector2d> sweep({1 / 3.0, 0, 2});
    sweep.add(0, 2, Vector2d(1, 2), 50);
    const Vector2d before = 3 * Vector2d(1, -2) + Vector2d(4, 1) / 2;
    std::vector<Vector2d> v{Vector2d(1, -2), Vector2d(5, 6), Vector2d(4, 1)};
    sweep.there_and_back(v, 0.1);
    CHECK((3 * v[0] + v[2] / 2 - before).norm() < 20 * eps);
    CHECK(std::fabs(v[0][0] - 1) > 0.1);
    // A damper so hard that it is rigid, to a held mass that moves: along it the mass moves with it, across it as
    // before.
    DamperSweep<Vector2d> rigid({1, 0});
    rigid.add(0, 1, Vector2d(0, 3), 1e300);
    std::vector<Vector2d> w{Vector2d(7, 8), Vector2d(1, 2)};
    rigid.there_and_back(w, 1e10);  // h c is past the largest number
    CHECK((w[0] - Vector2d(7, 2)).norm() < 20 * eps);
    CHECK(w[1] == Vector2d(1, 2));
    rigid.redirect(0, Vector2d(1, 0));
    rigid.there_and_back(w, 1);
    CHECK((w[0] - Vector2d(1, 2)).norm() < 20 * eps);
}

TEST_CASE("no dampers, soft ones of zero, those between held masses and without direction change nothing",
          "[library][ch3]") {
    DamperSweep<Vector2d> sweep({1, 0, 0});
    std::vector<Vector2d> v{Vector2d(1, 2), Vector2d(3, 4), Vector2d(5, 6)};
    const auto before = v;
    sweep.there_and_back(v, 0.1);
    sweep.add(0, 1, Vector2d(1, 0), 0);
    sweep.add(1, 2, Vector2d(1, 0), 1e6);
    sweep.add(0, 1, Vector2d(1, 0), 1e6);
    sweep.redirect(2, Vector2d(0, 0));  // two masses in one place
    sweep.there_and_back(v, 0.1);
    CHECK(v == before);
}

TEST_CASE("a sweep refuses masses and dampers that make no sense", "[library][ch3]") {
    const auto refuses = [](const auto& call, const char* line) {
        CHECK_THROWS_MATCHES(call(), std::invalid_argument, Message(line));
    };
    refuses([] { DamperSweep<double>({1, -2}); }, "inverse mass = -2: must be finite and zero or more");
    DamperSweep<Vector2d> sweep({1, 1e308, 1e308});
    const Vector2d along(1, 0);
    refuses([&] { sweep.add(0, 3, along, 1); }, "a damper's masses: must be two of those given");
    refuses([&] { sweep.add(1, 1, along, 1); }, "a damper's masses: must be two of those given");
    refuses([&] { sweep.add(1, 2, along, 1); }, "sum of the inverse masses = inf: must be a finite number");
    refuses([&] { sweep.add(0, 1, along, -3); }, "damping = -3: must be finite and zero or more");
    refuses([&] { sweep.add(0, 1, along, 1e9); }, "damping / mass = inf: must be a finite number");
    refuses([&] { sweep.add(0, 1, Vector2d(0, 0), 1); }, "direction of a damper: must be finite and not zero");
    refuses([&] { sweep.add(0, 1, Vector2d(NAN, 0), 1); }, "direction of a damper: must be finite and not zero");
    refuses([&] { sweep.redirect(0, along); }, "damper: must be one of those added");
    sweep.add(0, 1, along, 1);
    refuses([&] { sweep.redirect(0, Vector2d(INFINITY, 0)); }, "direction of a damper: must be finite");
    std::vector<Vector2d> v(2, Vector2d(0, 0));
    refuses([&] { sweep.there_and_back(v, 1); }, "velocities: must be one for each mass");
    v.resize(3);
    refuses([&] { sweep.there_and_back(v, 0); }, "step = 0: must be finite and greater than zero");
}
