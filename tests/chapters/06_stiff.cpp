// The claims of chapter 6 about stiff scenes: springs, dampers, two time scales, order reduction,
// Van der Pol and Robertson. The cloth has a file of its own.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Dense>

#include <timestep/measured_order.hpp>
#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/prothero_robinson.hpp>
#include <timestep/models/robertson.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/models/van_der_pol.hpp>
#include <timestep/run.hpp>

#include "chapters/06_stability/study/adaptive.hpp"
#include "chapters/06_stability/study/sdirk.hpp"

using namespace timestep;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double h = 1.0 / 60;

template <class Method, class Model>
double left_of(const Method& method, const Model& model, double omega, long steps) {
    const State<double> end = run(method, model, State<double>{0, 1, 0}, h, steps);
    return std::hypot(end.x, end.v / omega);
}

template <class Method>
double pull_error(const Method& method, double lambda, long steps, double uneven = 0) {
    const ProtheroRobinson<double> f(lambda);
    FirstOrder<double> state{0, 1};
    for (long i = 0; i < steps; ++i)
        state = method.step(f, state, (i % 2 == 0 ? 1 + uneven : 1 - uneven) / double(steps));
    return std::fabs(state.y - std::cos(1.0));
}

template <class Error>
double order_of(const Error& error) {
    std::vector<double> steps, errors;
    for (const long n : {10, 20, 40, 80}) steps.push_back(1.0 / double(n)), errors.push_back(error(n));
    return measured_order(steps, errors);
}

using Pair = Eigen::Vector2d;
using Shares = Eigen::Vector3d;

}  // namespace

TEST_CASE("a very stiff spring: explicit methods are gone, implicit ones stay", "[N62][ch6]") {
    for (double omega = 1e3; omega < 2e8; omega *= 10) {
        CAPTURE(omega);
        const Spring spring(omega);
        CHECK(!(left_of(explicit_euler, spring, omega, 60) < 1e6));
        CHECK(!(left_of(semi_implicit_euler, spring, omega, 60) < 1e6));
        CHECK(!(left_of(runge_kutta_4, spring, omega, 60) < 1e6));
        CHECK(!(left_of(velocity_verlet, spring, omega, 60) < 1e6));
        CHECK(left_of(implicit_euler, spring, omega, 600) < 1e-300);
        CHECK(left_of(bdf2, spring, omega, 600) < 1e-100);
        // Roundoff adds a few ε a step.
        CHECK(std::fabs(left_of(implicit_midpoint, spring, omega, 600) - 1) < 600 * 8 * eps);
    }
}

TEST_CASE("implicit midpoint rings with a hard damper, implicit Euler and BDF2 do not", "[ch6]") {
    for (const double zeta : {1e4, 1e6}) {
        const DampedSpring damper(10.0, zeta);
        const double c = 2 * zeta * 10 * h;
        const State<double> kicked{0, 0, 1};
        // The spring moves the velocity by less than h² ω² of it, 0.03, over c.
        const double once = implicit_midpoint.step(damper, kicked, h).v;
        CHECK(std::fabs(once - (1 - c / 2) / (1 + c / 2)) < 0.1 / c);
        CHECK(std::fabs(run(implicit_midpoint, damper, kicked, h, 100).v) > 0.8);
        CHECK(std::fabs(run(implicit_euler, damper, kicked, h, 1).v - 1 / (1 + c)) < 0.1 / c / c);
        CHECK(std::fabs(run(bdf2, damper, kicked, h, 100).v) < 1e-6);
        CHECK(std::fabs(run(semi_implicit_euler_new_damping, damper, kicked, h, 100).v) < 1e-6);
        CHECK(!(std::fabs(run(semi_implicit_euler, damper, kicked, h, 100).v) < 1e6));
    }
}

TEST_CASE("one fast oscillation decides the step of explicit methods, and costs implicit ones little", "[N62][ch6]") {
    // In step 1 rad/s, against each other 1e4 rad/s.
    const CoupledSprings<double, 2> row(Pair(1, 1), Shares(1, (1e8 - 1) / 2, 1));
    const State<Pair> start{0, Pair(1.001, 0.999), Pair(0, 0)};
    const auto after_ten = [&](const auto& method, double rate) {
        return run(method, row, start, 1 / rate, std::lround(10 * rate));
    };
    CHECK(!(after_ten(semi_implicit_euler, 4990).x.norm() < 1e6));
    CHECK(after_ten(semi_implicit_euler, 5010).x.norm() < 2);
    const auto slow = [](const State<Pair>& s) {
        return std::hypot(s.x.mean() - std::cos(10.0), s.v.mean() + std::sin(10.0));
    };
    const auto fast = [](const State<Pair>& s) { return std::hypot(s.x(0) - s.x(1), (s.v(0) - s.v(1)) / 1e4) / 2; };
    // 600 steps with h = 1/60 shrink a swing of 1 rad/s to (1 + h²)^(−300) = 0.920.
    const State<Pair> euler = after_ten(implicit_euler, 60);
    CHECK(std::fabs(slow(euler) - (1 - std::pow(1 + h * h, -300))) < 2e-3);
    CHECK(fast(euler) < 1e-15);
    // Its phase is t h²/12 late: 2.3e-4.
    const State<Pair> middle = after_ten(implicit_midpoint, 60);
    CHECK(std::fabs(slow(middle) / (10 * h * h / 12) - 1) < 0.02);
    CHECK(std::fabs(fast(middle) / 1e-3 - 1) < 1e-3);
    CHECK(fast(after_ten(bdf2, 60)) < 1e-15);
}

TEST_CASE("implicit midpoint swings a mass of 1 kg on a chain of 1e-12 kg", "[ch6]") {
    using Four = Eigen::Vector4d;
    const CoupledSprings<double, 4> chain(Four(1e-12, 1e-12, 1e-12, 1), Eigen::Matrix<double, 5, 1>(4, 4, 4, 4, 0));
    const State<Four> start{0, Four(0.25, 0.5, 0.75, 1), Four::Zero()};
    const State<Four> end = run(implicit_midpoint, chain, start, h, 600);
    // As a spring of 1 rad/s alone: its phase is 10 h²/12 late. 1 % is for the links' own swing.
    const double error = std::hypot(end.x(3) - std::cos(10.0), end.v(3) + std::sin(10.0));
    CHECK(std::fabs(error / (10 * h * h / 12) - 1) < 0.01);
    CHECK(!is_finite(run(semi_implicit_euler, chain, start, h, 600)));
}

TEST_CASE("a stiff pull takes an order from SDIRK, and from implicit midpoint on uneven steps", "[N60][ch6]") {
    CHECK(std::fabs(order_of([](long n) { return pull_error(sdirk_3, -1.0, n); }) - 3) < 0.1);
    CHECK(std::fabs(order_of([](long n) { return pull_error(sdirk_3, -1e6, n); }) - 2) < 0.1);
    // Away from stiffness both runs of implicit midpoint are of order two.
    for (const double uneven : {0.0, 0.25})
        CHECK(std::fabs(order_of([&](long n) { return pull_error(implicit_midpoint, -1.0, n, uneven); }) - 2) < 0.1);
    CHECK(std::fabs(order_of([](long n) { return pull_error(implicit_midpoint, -1e6, n); }) - 2) < 0.1);
    CHECK(std::fabs(order_of([](long n) { return pull_error(implicit_midpoint, -1e6, n, 0.25); }) - 1) < 0.1);
    // The step from t adds −h² y''/4 and turns the sign of what was off. Steps by turns 1 + u and 1
    // − u times h leave (1 − u)² − (1 + u)² = −4u of h²/4 a pair: u h/2 times ∫ −y'' dt over the
    // second.
    const double u = 0.25, n = 60;
    const double expected = u / (2 * n) * std::sin(1.0);
    CHECK(std::fabs(pull_error(implicit_midpoint, -1e6, 60, u) / expected - 1) < 0.05);
    // Implicit Euler's error is h y''/2 over λ.
    CHECK(std::fabs(pull_error(implicit_euler, -1e6, 60) / (std::cos(1.0) / 120e6) - 1) < 0.05);
}

TEST_CASE("explicit methods follow a stiff pull with steps below 2/|lambda|", "[N62][ch6]") {
    CHECK(pull_error(explicit_euler, -1e4, 5050) < 1e-6);
    CHECK(!(pull_error(explicit_euler, -1e4, 4950) < 1e6));
    CHECK(pull_error(runge_kutta_4, -1e4, 3600) < 1e-6);  // its limit is 2.785
    CHECK(!(pull_error(runge_kutta_4, -1e4, 3500) < 1e6));
}

// RADAU with 19 digits, for the Test Set for IVP Solvers (F. Mazzia and C. Magherini, Bari).
TEST_CASE("Van der Pol with mu = 1e6 meets the published value when the step adapts", "[ch6]") {
    const VanDerPol<double> f(1e6);
    const FirstOrder<Pair> start{0, Pair(2, 0)};
    const auto nobody = [](const auto&) {};
    Account account;
    const auto end = run_adaptive(f, start, 2.0, 1e-4, 1e-4, account, nobody);
    CHECK(end.t == 2);
    // A thousand times the tolerance: each of the two jumps turns what is off into a delay.
    CHECK(std::fabs(end.y(0) - 1.706167732170483) < 1e-3);
    CHECK(std::fabs(end.y(1) + 0.8928097010247975) < 1e-3);
    CHECK(account.steps < 10000);
    // With even steps of a millisecond Newton–Raphson finds no root at the first jump.
    const double step = 1e-3;
    FirstOrder<Pair> state = start;
    double lost = 2;
    for (int i = 0; i < 2000 && lost == 2; ++i) {
        const FirstOrder<Pair> next = implicit_euler.step(f, state, step);
        if (std::fabs(next.y(0) - state.y(0) - step * next.y(1)) > 1e-6) lost = state.t;
        state = next;
    }
    // The creep v = x/(1 − x²) from 2 to 1 takes 3/2 − ln 2.
    CHECK(std::fabs(lost - (1.5 - std::log(2))) < 0.01);
}

TEST_CASE("Robertson's reaction to t = 40 and to t = 1e11", "[ch6]") {
    const Robertson<double> f;
    const FirstOrder<Shares> start{0, Shares(1, 0, 0)};
    const auto nobody = [](const auto&) {};
    Account account;
    const auto late = run_adaptive(f, start, 1e11, 1e-4, 1e-14, account, nobody);
    const Shares published(0.2083340149701255e-7, 0.8333360770334713e-13, 0.9999999791665050);
    CHECK((late.y - published).cwiseQuotient(published).cwiseAbs().maxCoeff() < 1e-3);
    CHECK(std::fabs(late.y.sum() - 1) < 1e-12);
    CHECK(account.steps < 5000);
    // At t = 40 two ways: a step that adapts, of order two, against implicit midpoint with even
    // steps.
    const auto soon = run_adaptive(f, start, 40.0, 1e-6, 1e-14, account, nobody);
    const auto even = run(implicit_midpoint, f, start, 1e-3, 40000);
    CHECK((soon.y - even.y).cwiseAbs().maxCoeff() < 1e-6);
    CHECK(std::fabs(soon.y(0) - 0.7158270687193941) < 1e-6);
    CHECK(std::fabs(soon.y(1) / 0.9185534764558135e-5 - 1) < 1e-5);
    CHECK(!is_finite(run(explicit_euler, f, start, 40.0 / 60000, 60000)));
    CHECK(is_finite(run(explicit_euler, f, start, 40.0 / 80000, 80000)));
}

// The chapter's rule for scenes of many springs: at each body the sum of k (1/m + r²/I), twice the largest
// of them. A spring's energy is at most twice what its ends would store one by one, and an end of a body
// moves by no more than its energy lets it: u² ≤ (1/m + r²/I) (m|v|² + I w²).
TEST_CASE("twice the largest sum of k (1/m + r^2/I) is never below the fastest oscillation", "[ch6]") {
    std::mt19937 random(6);
    const auto between = [&](double low, double high) { return low * std::pow(high / low, random() / 4294967296.0); };
    double nearest = 0;
    for (int scene = 0; scene < 300; ++scene) {
        const int bodies = 1 + int(random() % 5), springs = 1 + int(random() % 12);
        Eigen::VectorXd mass(3 * bodies), sum = Eigen::VectorXd::Zero(bodies);  // x, y, turn of each
        for (int b = 0; b < bodies; ++b) {
            mass.segment(3 * b, 2).setConstant(between(0.1, 10));
            mass[3 * b + 2] = between(0.01, 10);
        }
        Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(3 * bodies, 3 * bodies);
        for (int n = 0; n < springs; ++n) {
            const double k = between(1, 1e4), way = between(1, 600) / 100;
            Eigen::VectorXd stretch = Eigen::VectorXd::Zero(3 * bodies);
            const auto holds = [&](int b, double sign) {
                const double r = between(0.01, 2), place = between(1, 600) / 100;
                stretch[3 * b] = sign * std::cos(way), stretch[3 * b + 1] = sign * std::sin(way);
                stretch[3 * b + 2] = sign * r * std::sin(way - place);  // the arm's part across the spring
                sum[b] += k * (1 / mass[3 * b] + r * r / mass[3 * b + 2]);
            };
            const int one = int(random() % unsigned(bodies)), other = int(random() % unsigned(bodies));
            holds(one, 1);
            if (other != one) holds(other, -1);  // else the other end is the world's
            stiffness += k * stretch * stretch.transpose();
        }
        const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
        const Eigen::MatrixXd scaled = root.asDiagonal() * stiffness * root.asDiagonal();
        const double fastest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled).eigenvalues().maxCoeff();
        CHECK(fastest <= 2 * sum.maxCoeff() * (1 + 1e-12));
        if (bodies == 1) CHECK(fastest <= sum.maxCoeff() * (1 + 1e-12));  // nothing but the world to swing against
        nearest = std::max(nearest, fastest / (2 * sum.maxCoeff()));
    }
    CHECK(nearest > 0.7);  // so the factor two is needed
}
