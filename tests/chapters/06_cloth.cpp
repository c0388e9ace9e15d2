// The claims of chapter 6 about a cloth of stiff springs.
#include <catch2/catch_test_macros.hpp>

#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "chapters/06_stability/study/cloth.hpp"

namespace {

using Vector = Eigen::VectorXd;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double frame = 1.0 / 60;

// A cloth that has been pulled out of its plane, all links taut.
Cloth pulled(int n, double stiffness) {
    Cloth cloth(n, stiffness);
    cloth.x() *= 1.1;
    for (int i = 0; i < n * n; ++i) {
        cloth.x()(3 * i + 2) = 0.02 * std::sin(1.0 * i);
        cloth.v()(3 * i) = 0.1 * std::cos(2.0 * i);
    }
    for (const int i : {0, n - 1}) cloth.v().segment<3>(3 * i).setZero();
    return cloth;
}

double reach(const Cloth& cloth) { return cloth.x().cwiseAbs().maxCoeff(); }

}  // namespace

TEST_CASE("the cloth's links pull with equal and opposite forces", "[ch6]") {
    Cloth cloth = pulled(5, 100);
    Eigen::Vector3d sum(0, 0, 0);
    // The corners that are held hide their force, so what the others feel is their weight and what
    // the corners' links pull: with a cloth at rest length it is the weight alone.
    cloth = Cloth(5, 100);
    const Vector f = cloth.force();
    for (int i = 0; i < 25; ++i) sum += f.segment<3>(3 * i);
    CHECK(std::fabs(sum(2) + 9.81 * 23 * cloth.mass()) < 1e-14);
    CHECK(sum.head<2>().norm() < 100 * eps * 100);
}

TEST_CASE("the tangent of the cloth's force is its derivative where every link is taut", "[ch6]") {
    const Cloth cloth = pulled(4, 50);
    for (const auto& link : cloth.links())
        REQUIRE((cloth.x().segment<3>(3 * link.a) - cloth.x().segment<3>(3 * link.b)).norm() > link.length);
    const Tangent tangent(cloth, frame);
    Vector y(cloth.x().size());
    for (int i = 0; i < y.size(); ++i) y(i) = std::sin(3.0 * i + 1);
    cloth.hold(y);
    const double d = 1e-5;
    Cloth more = cloth, less = cloth;
    more.x() += d * y, less.x() -= d * y;
    const Vector difference = (less.force() - more.force()) / (2 * d);
    // d² times a third derivative of 50/length² ~ 500, times 8 links; roundoff 50 ε/d.
    CHECK((tangent.k_times(y) - difference).norm() < 1e-5);
    CHECK(difference.norm() > 10);
}

TEST_CASE("factors and conjugate gradients take the same step", "[ch6]") {
    for (const double stiffness : {1e2, 1e4}) {
        const Cloth start = pulled(6, stiffness);
        Cloth a = start, b = start;
        Factorised(a).step(a, frame);
        const int products = step_gradients(b, frame, 1e-12);
        CHECK((a.x() - b.x()).norm() < 1e-8 * (a.x() - start.x()).norm());
        CHECK(products > 10);
        // It solves the step's own equation: (m + h² K) Δv = h (f − h K v).
        const Tangent tangent(start, frame);
        const Vector left = tangent.times(a.v() - start.v()) - tangent.right_side();
        CHECK(left.norm() < 1e-10 * tangent.right_side().norm());
        // The corners have not moved.
        CHECK(a.x().head<3>() == start.x().head<3>());
        CHECK(b.x().head<3>() == start.x().head<3>());
    }
}

TEST_CASE("the cloth's matrix is symmetric with positive eigenvalues, taut or slack", "[ch6]") {
    for (const double size : {1.1, 0.8}) {
        Cloth cloth = pulled(5, 1e4);
        cloth.x() *= size / 1.1;
        Factorised factorised(cloth);
        Cloth next = cloth;
        factorised.step(next, frame);
        const Cloth::Sparse full = factorised.matrix().selfadjointView<Eigen::Lower>();
        const Tangent tangent(cloth, frame);
        Vector y = Vector::Zero(full.rows());
        for (int j = 3; j < 12; ++j) {
            y.setZero(), y(j) = 1;
            CHECK((full * y - tangent.times(y)).norm() < 1e-10 * full.norm());
        }
        // Every eigenvalue is above 0.99 m: with so much taken from the diagonal there still are
        // Cholesky's factors, which only a matrix with positive eigenvalues has.
        Eigen::SimplicialLLT<Cloth::Sparse> factors;
        factors.setShift(-0.99 * cloth.mass());
        factors.compute(full);
        CHECK(factors.info() == Eigen::Success);
        factors.setShift(-1.01 * cloth.mass());  // that of the corners is m itself
        factors.compute(full);
        CHECK(factors.info() != Eigen::Success);
    }
}

TEST_CASE("the cloth's fastest oscillation is the root of 8k/m, and half of h times it are enough steps",
          "[I12][N62][ch6]") {
    const Cloth flat(14, 1e4);
    const Tangent tangent(flat, frame);
    Vector y(flat.x().size());
    for (int i = 0; i < y.size(); ++i) y(i) = std::sin(7.0 * i * i + 1);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        y = tangent.k_times(y.normalized());
        largest = y.norm() / flat.mass();
    }
    // The free edges lower it a little, and power iteration comes from below.
    CHECK(largest < flat.fastest() * flat.fastest() * (1 + 1e-12));
    CHECK(largest > 0.97 * flat.fastest() * flat.fastest());

    const auto survives = [](double factor) {
        Cloth cloth(14, 1e4);
        const long steps = std::lround(std::ceil(factor * frame * cloth.fastest() / 2));
        for (long i = 0; i < 60 * steps; ++i) {
            step_explicit(cloth, frame / double(steps));
            if (!(reach(cloth) < 10)) return false;
        }
        return true;
    };
    CHECK(survives(1));
    CHECK(!survives(0.9));
}

TEST_CASE("implicit Euler's cloth stands for ten seconds at any stiffness, solved well or roughly", "[I12][ch6]") {
    for (const double stiffness : {1e2, 1e4, 1e8}) {
        CAPTURE(stiffness);
        Cloth cloth(8, stiffness), rough(8, stiffness), one(8, stiffness);
        Factorised factorised(cloth);
        for (int i = 0; i < 600; ++i) {
            factorised.step(cloth, frame);
            step_gradients(rough, frame, 1e-2);
            if (reach(one) < 10) step_explicit(one, frame);
        }
        CHECK(reach(cloth) < 1.1);
        CHECK(reach(rough) < 1.1);
        CHECK(!(reach(one) < 10));
    }
}
