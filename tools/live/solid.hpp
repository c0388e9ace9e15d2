#pragma once
// Solid bodies in a picture: convex parts, shaded, and a view of them that a finger turns. No sine and no cosine, so
// that what is drawn has the same bits everywhere.

#include <array>
#include <cmath>
#include <cstddef>

#include <timestep/rigid/rotation.hpp>

#include "live.hpp"

namespace live {

using Place = timestep::Vector3<double>;
using Orientation = timestep::Quaternion<double>;

// From far away, at first along the world's y axis and 18° downwards; the world's z axis points up. Sideways a finger
// turns the world about that axis; upwards it tips it, never so far that it is seen from below.
class View {
public:
    // In the picture to the right, upwards, and towards the eye.
    Place seen(const Place& world) const { return world_to_screen_ * world; }

    void grab(double x, double y) { x_ = x, y_ = y; }
    void drag(double x, double y) {
        const double faster = 2;  // rad per unit of the picture
        const Orientation before = world_to_screen_;
        world_to_screen_ = timestep::turned_in_body(world_to_screen_, Place(0, 0, x - x_), faster);
        const Orientation sideways = world_to_screen_;
        world_to_screen_ = timestep::turned(sideways, Place(y_ - y, 0, 0), faster);
        const Place up = seen(Place::UnitZ());
        if (!(up.y() > 0.05 && up.z() > 0.05)) world_to_screen_ = sideways;
        if (!timestep::is_finite(world_to_screen_.coeffs())) world_to_screen_ = before;
        grab(x, y);
    }

private:
    Orientation world_to_screen_{Orientation(1, -0.7265, 0, 0).normalized()};  // tan 36°: 72° about x
    double x_ = 0, y_ = 0;
};

// Twelve points of the unit circle: 30° has the sine ½.
inline std::array<double, 2> twelfth(int i) {
    static const double c = std::sqrt(0.75), cosines[] = {1, c, 0.5, 0, -0.5, -c, -1, -c, -0.5, 0, 0.5, c};
    return {cosines[i % 12], cosines[(i + 9) % 12]};
}

// A convex body, or one made of a few convex parts.
class Solid {
public:
    // A box about `centre`; along the axis `marked` its upper end is orange and its lower one blue.
    void add_box(const Place& centre, const Place& sides, int marked) {
        begin_part(centre);
        for (int i = 0; i < 3; ++i)
            for (const int side : {-1, 1}) {
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                Face& face = add(i != marked ? "soft" : side > 0 ? "second" : "first");
                for (const auto& [a, b] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
                    Place corner;
                    corner[i] = side * sides[i] / 2, corner[j] = a * side * sides[j] / 2, corner[k] = b * sides[k] / 2;
                    face.corners[static_cast<std::size_t>(face.count++)] = centre + corner;
                }
            }
    }

    // A capsule along z, one side of it orange and the other blue, so that its spin shows.
    void add_capsule(double radius, double half_length) {
        begin_part(Place::Zero());
        const auto at = [&](int ring, int sector) {  // rings from below, 0 to 7
            const auto [out, up] = twelfth(ring < 4 ? ring + 9 : ring + 8);
            const auto [x, y] = twelfth(sector);
            return Place(radius * out * x, radius * out * y, radius * up + (ring < 4 ? -half_length : half_length));
        };
        for (int ring = 0; ring < 7; ++ring)
            for (int sector = 0; sector < 12; ++sector) {
                Face& face = add(ring > 4 ? "soft" : sector < 6 ? "second" : "first");
                if (ring > 0) face.corners[static_cast<std::size_t>(face.count++)] = at(ring, sector);
                face.corners[static_cast<std::size_t>(face.count++)] = at(ring, sector + 1);
                face.corners[static_cast<std::size_t>(face.count++)] = at(ring + 1, sector + 1);
                if (ring < 6) face.corners[static_cast<std::size_t>(face.count++)] = at(ring + 1, sector);
                if (ring == 0) face.corners[static_cast<std::size_t>(face.count++)] = at(0, sector);
            }
    }

    // Turned by `q`, its origin at (x, y) of the picture. What looks away from the eye is hidden. Of several parts the
    // nearer ones are drawn over the others.
    void draw(Picture& p, const View& view, const Orientation& q, double x, double y) const {
        std::array<bool, most_parts> drawn{};
        for (int n = 0; n < parts_; ++n) {
            int farthest = -1;
            const auto depth = [&](int part) { return view.seen(q * centre_[static_cast<std::size_t>(part)]).z(); };
            for (int part = 0; part < parts_; ++part)
                if (!drawn[static_cast<std::size_t>(part)] && (farthest < 0 || depth(part) < depth(farthest)))
                    farthest = part;
            drawn[static_cast<std::size_t>(farthest)] = true;
            for (int i = 0; i < faces_; ++i) {
                const Face& face = face_[static_cast<std::size_t>(i)];
                if (face.part == farthest) draw(p, view, q, x, y, face);
            }
        }
    }

private:
    static constexpr std::size_t most_faces = 84, most_parts = 4;
    struct Face {
        std::array<Place, 4> corners;  // counterclockwise seen from outside
        int count, part;
        const char* paint;
    };

    void begin_part(const Place& centre) { centre_[static_cast<std::size_t>(parts_++)] = centre; }
    Face& add(const char* paint) {
        Face& face = face_[static_cast<std::size_t>(faces_++)];
        face.count = 0, face.part = parts_ - 1, face.paint = paint;
        return face;
    }
    static void draw(Picture& p, const View& view, const Orientation& q, double x, double y, const Face& face) {
        std::array<Place, 4> corners;
        for (std::size_t i = 0; i < 4; ++i) corners[i] = view.seen(q * face.corners[i]);
        const Place normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]).normalized();
        if (!(normal.z() > 0)) return;
        const double lit = normal.dot(Place(-0.48, 0.64, 0.6));  // light from behind the reader's left shoulder
        p.ink(face.paint);
        for (int i = 0; i < face.count; ++i) {
            const Place& c = corners[static_cast<std::size_t>(i)];
            i == 0 ? p.move(x + c.x(), y + c.y()) : p.line(x + c.x(), y + c.y());
        }
        p.fill();
        p.ink(lit > 0.5 ? "paper" : "ink", 1, lit > 0.5 ? lit - 0.5 : 0.35 * (0.5 - lit));
        p.fill();
    }

    std::array<Face, most_faces> face_{};
    std::array<Place, most_parts> centre_{};
    int faces_ = 0, parts_ = 0;
};

}  // namespace live
