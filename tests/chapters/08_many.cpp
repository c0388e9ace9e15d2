// Chapter 8's film: the faces of its bodies look outwards, and none is missing.

#include <catch2/catch_test_macros.hpp>

#include <cmath>

#include "solids.hpp"

namespace {

// Of a closed surface whose corners go round seen from outside, the area vectors add up to nothing,
// and a third of the sum of corner · area is the volume: negative where faces look inwards.
void closed(const std::vector<film::Face>& faces, double least, double most) {
    film::V sum(0, 0, 0);
    double volume = 0;
    for (const auto& face : faces) {
        REQUIRE(face.corners.size() == 4);
        const auto& c = face.corners;
        for (int i = 1; i + 1 < 4; ++i) {
            const film::V area = (c[i] - c[0]).cross(c[i + 1] - c[0]) / 2;
            CHECK(area.dot(c[0]) > 0);  // the origin is inside
            sum += area;
            volume += c[0].dot(area) / 3;
        }
    }
    CHECK(sum.norm() < 1e-12);
    CHECK(volume >= least);
    CHECK(volume <= most);
}

}  // namespace

TEST_CASE("a film's box and ball are closed and look outwards", "[ch8]") {
    closed(film::box(1, 2, 3, 0), 6 - 1e-12, 6 + 1e-12);
    // A ball of flat faces is less than the ball, and this one more than nine tenths of it.
    const double ball = 4 * std::acos(-1.0) / 3;
    closed(film::ball(1, 0), 0.9 * ball, ball);
}
