// The claims of chapter 6 about a cloth of stiff springs.
#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include <Eigen/Core>

#include "chapters/06_stability/study/cloth.hpp"

namespace {

using Vector = Eigen::VectorXd;
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

}  // namespace

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
