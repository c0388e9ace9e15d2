// Linear equations in one spelling for numbers and matrices, and the eigenvectors of a symmetric matrix.
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

#include <Eigen/Core>
#include <Eigen/Dense>
#include <timestep/checks.hpp>
#include <timestep/eigenvectors.hpp>
#include <timestep/linear_solve.hpp>

using namespace timestep;

// All numbers below are small multiples of powers of two, so every result is exact.

TEMPLATE_TEST_CASE("numbers are solved by division, matrices by elimination", "[library]", float, double, long double) {
    CHECK(solve(TestType(4), TestType(10)) == TestType(2.5));
    CHECK(magnitude(TestType(-3)) == 3);
    CHECK(outer(TestType(2), TestType(3)) == 6);
    using Vector = Eigen::Matrix<TestType, 2, 1>;
    using Matrix = Eigen::Matrix<TestType, 2, 2>;
    Matrix a;
    a << 0, 2, 4, 1;  // a zero on the diagonal: needs pivoting
    CHECK(solve(a, Vector(6, 11)) == Vector(2, 3));
    CHECK(solve(TestType(4), Vector(8, 2)) == Vector(2, TestType(0.5)));
    CHECK(identity<Matrix>() == Matrix::Identity());
    CHECK(zero<Vector>() == Vector::Zero());
    CHECK(magnitude(Vector(3, -4)) == 5);
    Matrix products;
    products << 8, 10, 12, 15;
    CHECK(outer(Vector(2, 3), Vector(4, 5)) == products);
}

// Of `a`, what is left of the second column is 0, 0 and 4: without a swap there would be no answer.
TEST_CASE("an elimination takes the largest pivot in every column", "[library]") {
    Eigen::Matrix4d a;
    a << 4, 8, 4, 0,  //
        2, 4, 2, 8,   //
        1, 2, 2, 1,   //
        0, 4, 8, 4;
    CHECK(solve(a, Eigen::Vector4d(a * Eigen::Vector4d(1, -2, 4, 8))) == Eigen::Vector4d(1, -2, 4, 8));
    const Eigen::Matrix3d b = a.topLeftCorner<3, 3>() + Eigen::Vector3d(0, 0, 1) * Eigen::RowVector3d(0, 2, 0);
    CHECK_FALSE(is_finite(solve(b, Eigen::Vector3d(1, 2, 3))));  // its second row is half of the first
    // The largest number comes to the top: the small one above it would leave no digit of the 2.
    Eigen::Matrix2d tiny;
    tiny << 0x1p-80, 1, 1, 1;
    CHECK(solve(tiny, Eigen::Vector2d(1, 2)) == Eigen::Vector2d(1, 1));
}

TEST_CASE("the matrix of an implicit step is a number where both slopes are, else a matrix", "[library]") {
    CHECK(implicit_matrix(0.5, -2.0, -4.0) == 1 + 1 + 1);
    Eigen::Matrix2d slope;
    slope << -4, 8, 0, -16;
    Eigen::Matrix2d as_position, as_velocity;
    as_position << 1 + 1 + 1, -2, 0, 1 + 1 + 4;      // 1 − h (−2) − h² slope, h = ½
    as_velocity << 1 + 2 + 0.5, -4, 0, 1 + 8 + 0.5;  // 1 − h slope − h² (−2)
    CHECK(implicit_matrix(0.5, -2.0, slope) == as_position);
    CHECK(implicit_matrix(0.5, slope, -2.0) == as_velocity);
    CHECK(implicit_matrix(0.5, slope, slope) == Eigen::Matrix2d(Eigen::Matrix2d::Identity() - 0.75 * slope));
}

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
