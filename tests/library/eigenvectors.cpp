// A symmetric matrix seen from its own axes is diagonal.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Core>
#include <timestep/eigenvectors.hpp>

using namespace timestep;

namespace {

// How far, in ε of the largest number, the parts that are found are from making up the matrix, and
// the axes from right angles.
template <class Matrix>
double residual(const Matrix& a) {
    Matrix values = a;
    const Matrix axes = eigenvectors(values);
    double worst = 0, largest = 0;
    for (int i = 0; i < a.rows(); ++i)
        for (int j = 0; j < a.rows(); ++j) {
            double back = 0, angle = i == j ? -1 : 0;
            for (int k = 0; k < a.rows(); ++k) {
                back += double(axes(i, k)) * double(values(k, k)) * double(axes(j, k));
                angle += double(axes(k, i)) * double(axes(k, j));
            }
            largest = std::max(largest, std::abs(double(a(i, j))));
            worst = std::max({worst, std::abs(back - double(a(i, j))), std::abs(angle) * largest});
            if (i != j && values(i, j) != 0) return INFINITY;
            if (i < j && !(values(i, i) <= values(j, j))) return INFINITY;  // rising
        }
    return largest == 0 ? 0 : worst / largest / double(std::numeric_limits<real_of<Matrix>>::epsilon());
}

}  // namespace

// Each of some fifteen turns rounds two or three times: half a million matrices were off by 8 ε at
// the most.
TEMPLATE_TEST_CASE("a symmetric matrix is the sum of its eigenvectors", "[library]", float, double) {
    using Matrix = Eigen::Matrix<TestType, 3, 3>;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    double worst = 0;
    for (int n = 0; n < 20000; ++n) {
        Matrix a;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j <= i; ++j)
                a(i, j) = a(j, i) = TestType(n % 3 == 0 ? std::round(normal(random))  // many alike
                                                        : std::exp(5 * normal(random)));
        worst = std::max(worst, residual(a));
    }
    CHECK(worst < 16);
}

TEST_CASE("eigenvectors of what is diagonal already are its axes, in their order", "[library]") {
    Eigen::Matrix2d a;
    a << 3, 0, 0, -1;
    const Eigen::Matrix2d axes = eigenvectors(a);
    CHECK(a(0, 0) == -1);
    CHECK(a(1, 1) == 3);
    CHECK(axes(0, 0) == 0);
    CHECK(axes(1, 0) == 1);
    // Two equal springs, coupled: together and against each other, at 45 degrees.
    a << 2, -1, -1, 2;
    CHECK(residual(a) < 4);
    eigenvectors(a);
    CHECK(std::abs(a(0, 0) - 1) < 1e-15);
    CHECK(std::abs(a(1, 1) - 3) < 1e-15);
}
