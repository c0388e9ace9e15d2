#pragma once
// Convex bodies as faces, for the film.

#include <vector>

#include <timestep/rigid/rotation.hpp>

namespace film {

using V = timestep::Vector3<double>;

struct Face {
    std::vector<V> corners;  // counterclockwise seen from outside, body coordinates
    int paint;
};

// A box with sides a, b, c.
inline std::vector<Face> box(double a, double b, double c, int paint) {
    std::vector<Face> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {1.0, -1.0}) {
            Face face{{}, paint};
            const double turn[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            for (const auto& at : turn) {
                V corner;
                corner[axis] = side;
                corner[(axis + 1) % 3] = side * at[0], corner[(axis + 2) % 3] = at[1];
                face.corners.push_back(corner.cwiseProduct(V(a, b, c) / 2));
            }
            faces.push_back(face);
        }
    return faces;
}

// A ball of square faces, a cube blown up.
inline std::vector<Face> ball(double radius, int paint) {
    constexpr int parts = 4;
    std::vector<Face> faces;
    for (const Face& side : box(1, 1, 1, paint))
        for (int i = 0; i < parts; ++i)
            for (int j = 0; j < parts; ++j) {
                const V &origin = side.corners[0], u = side.corners[1] - origin,
                        v = side.corners[3] - origin;
                const auto at = [&](int k, int l) {
                    return V(radius * (origin + u * k / parts + v * l / parts).normalized());
                };
                faces.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, paint});
            }
    return faces;
}

}  // namespace film
