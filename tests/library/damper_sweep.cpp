// Dampers solved one after another, there and back: what the sweep is, that it is stable, what it refuses.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>

#include <Eigen/Dense>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <timestep/damper_sweep.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>

using namespace timestep;
using Catch::Matchers::Message;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

// Springs and dampers between masses in a plane. Rows of springs and dampers act on all velocities, two numbers a mass.
struct Network {
    std::vector<double> inverse_masses;
    struct Part {
        std::size_t a, b;
        Vector2d along;
        double k, c;
    };
    std::vector<Part> parts;
    double h;

    Eigen::Index size() const { return 2 * Eigen::Index(inverse_masses.size()); }

    // In u = √m v a damper's row is n/√m at one mass, −n/√m at the other.
    VectorXd row(const Part& part) const {
        VectorXd g = VectorXd::Zero(size());
        g.segment<2>(2 * Eigen::Index(part.a)) = std::sqrt(inverse_masses[part.a]) * part.along.normalized();
        g.segment<2>(2 * Eigen::Index(part.b)) = -std::sqrt(inverse_masses[part.b]) * part.along.normalized();
        return g;
    }
    MatrixXd K() const {
        MatrixXd sum = MatrixXd::Zero(size(), size());
        for (const Part& part : parts) sum += part.k * row(part) * row(part).transpose();
        return sum;
    }
    double fastest() const { return std::sqrt(Eigen::SelfAdjointEigenSolver<MatrixXd>(K()).eigenvalues().maxCoeff()); }

    // What the library does to velocities, in u: column i is what becomes of the i-th unit vector. No mass is held
    // here.
    MatrixXd swept() const {
        DamperSweep<Vector2d> sweep(inverse_masses);
        for (const Part& part : parts) sweep.add(part.a, part.b, part.along, part.c);
        MatrixXd D(size(), size());
        for (Eigen::Index i = 0; i < size(); ++i) {
            std::vector<Vector2d> v(inverse_masses.size(), Vector2d::Zero());
            v[std::size_t(i / 2)][i % 2] = std::sqrt(inverse_masses[std::size_t(i / 2)]);
            sweep.there_and_back(v, h);
            for (std::size_t n = 0; n < v.size(); ++n)
                D.block<2, 1>(2 * Eigen::Index(n), i) = v[n] / std::sqrt(inverse_masses[n]);
        }
        return D;
    }
    // Each damper divided once, one after another: what a course may not recommend.
    MatrixXd one_way() const {
        MatrixXd D = MatrixXd::Identity(size(), size());
        for (const Part& part : parts) {
            const VectorXd g = row(part);
            D -= h * part.c / (1 + h * part.c * g.squaredNorm()) * g * (g.transpose() * D).eval();
        }
        return D;
    }
    // All of them as one system, from the other side: D⁻¹ = 1 + h Σ c g gᵀ.
    MatrixXd inverse_of_one_matrix() const {
        MatrixXd sum = MatrixXd::Identity(size(), size());
        for (const Part& part : parts) sum += h * part.c * row(part) * row(part).transpose();
        return sum;
    }
};

// Two to five masses of 0.1 to 10 kg, each pair tied at random in a random direction; dampers from soft to hard; ωh as
// wanted.
Network random_network(std::mt19937& random, double wh) {
    const auto from = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Network net{{}, {}, from(1e-3, 0.1)};
    const std::size_t masses = 2 + random() % 4;
    for (std::size_t i = 0; i < masses; ++i) net.inverse_masses.push_back(std::pow(10, from(-1, 1)));
    for (std::size_t a = 0; a < masses; ++a)
        for (std::size_t b = 0; b < a; ++b)
            for (int n = 0; n < 2; ++n)
                net.parts.push_back(
                    {a, b, Vector2d(from(-1, 1), from(-1, 1)), from(0, 1), std::pow(10, from(-2, 5)) / net.h});
    const double scale = wh / (net.fastest() * net.h);
    for (auto& part : net.parts) part.k *= scale * scale;
    return net;
}

}  // namespace

TEMPLATE_TEST_CASE("one damper there and back is semi-implicit Euler with new damping, to roundoff", "[library][ch3]",
                   float, double, long double) {
    using Real = TestType;
    for (const Real zeta : {Real(0), Real(1e-4), Real(0.1), Real(1), Real(30), Real(1e6)}) {
        const Real omega = 50, h = Real(1) / 60, m = 3;
        const DampedSpring<Real> spring(omega, zeta);
        const State<Real> one{0, Real(0.3), Real(-7)}, two = semi_implicit_euler_new_damping.step(spring, one, h);
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

TEST_CASE("the sweep there and back is symmetric and between 0 and 1, and one way it is not symmetric",
          "[library][ch3]") {
    std::mt19937 random(1);
    double most_skewed = 0;
    for (int n = 0; n < 100; ++n) {
        const Network net = random_network(random, 1);
        const MatrixXd D = net.swept(), once = net.one_way();
        const double rounded = 40 * eps * double(net.parts.size());
        CHECK((D - D.transpose()).cwiseAbs().maxCoeff() < rounded);
        const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(D).eigenvalues();
        CHECK(values.minCoeff() > -rounded);
        CHECK(values.maxCoeff() < 1 + rounded);
        most_skewed = std::max(most_skewed, (once - once.transpose()).cwiseAbs().maxCoeff());
    }
    CHECK(most_skewed > 0.1);
}

TEST_CASE("dampers that are perpendicular or share no mass are one system there and back, to roundoff",
          "[library][ch3]") {
    const Network net{{1, 0.3, 2, 5, 0.7},
                      {{0, 1, Vector2d(1, 2), 0, 70}, {0, 2, Vector2d(-2, 1), 0, 3e4}, {3, 4, Vector2d(3, 1), 0, 500}},
                      0.1};
    CHECK((net.swept() * net.inverse_of_one_matrix() - MatrixXd::Identity(10, 10)).cwiseAbs().maxCoeff() <
          1e4 * 20 * eps);
    Network skew = net;
    skew.parts[1].along = Vector2d(1, 1);
    CHECK((skew.swept() * skew.inverse_of_one_matrix() - MatrixXd::Identity(10, 10)).cwiseAbs().maxCoeff() > 0.1);
}

// The proof of the header in numbers. G = D⁻¹ − 1 is known to ε/(least eigenvalue of D), so the dampers are not too
// hard.
TEST_CASE("the modified energy falls by the proof's term in every step, at omega h = 1.99", "[library][ch3]") {
    std::mt19937 random(2);
    for (int n = 0; n < 50; ++n) {
        Network net = random_network(random, 1.99);
        for (auto& part : net.parts) part.c = std::min(part.c, 1 / net.h);
        const MatrixXd D = net.swept(), K = net.K(), G = D.inverse() - MatrixXd::Identity(net.size(), net.size());
        const double h = net.h;
        VectorXd y = VectorXd::Random(net.size()) * h, u = VectorXd::Random(net.size());
        const auto energy = [&] { return (u.dot(u + G * u / 2) + y.dot(K * y) - h * u.dot(K * y)) / 2; };
        const double least = (u.squaredNorm() + y.dot(K * y)) / 2 * (1 - 1.99 / 2);
        CHECK(energy() >= least * (1 - 1e-9));
        const double scale = energy() * (1 + G.norm());
        for (int step = 0; step < 20; ++step) {
            const double before = energy();
            const VectorXd u1 = u;
            u = D * (u - h * (K * y));
            y += h * u;
            CHECK(std::fabs(energy() - before + (u1 + u).dot(G * (u1 + u)) / 4) < 1e-9 * scale);
        }
    }
}

// A hub and twelve masses round it, in a plane, each held to its neighbours by springs with a damper beside each. ωh is
// 0.5, and the wheel turns by 0.2 rad per step. Its most energy in 6000 steps, over the first.
static double most_energy_of_a_wheel(double damping) {
    const double pi = std::numbers::pi;
    std::vector<Vector2d> x{Vector2d(0, 0)}, v;
    for (int i = 0; i < 12; ++i) x.push_back(Vector2d(std::cos(i * pi / 6), std::sin(i * pi / 6)));
    for (const Vector2d& each : x) v.push_back(0.2 * Vector2d(-each.y(), each.x()));
    Network wheel{std::vector<double>(13, 1.0), {}, 1};
    for (std::size_t i = 1; i <= 12; ++i)
        for (const std::size_t other : {std::size_t(0), i % 12 + 1})
            wheel.parts.push_back({other, i, x[i] - x[other], 1, damping});
    const double k = 0.25 / (wheel.fastest() * wheel.fastest());
    DamperSweep<Vector2d> sweep(wheel.inverse_masses);
    for (const Network::Part& part : wheel.parts) sweep.add(part.a, part.b, part.along, part.c);
    double first = 0, most = 0;
    for (int n = 0; n <= 6000; ++n) {
        double energy = 0;
        for (const Vector2d& each : v) energy += each.squaredNorm() / 2;
        for (std::size_t i = 0; i < wheel.parts.size(); ++i) {
            const auto& [a, b, along, stiffness, c] = wheel.parts[i];
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
