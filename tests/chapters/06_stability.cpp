// Chapter 6: the rule for scenes of many springs.

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Dense>

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
