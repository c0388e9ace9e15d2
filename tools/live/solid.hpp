#pragma once
// Solid bodies in a picture: convex parts, shaded, and a view of them that a finger turns. No sine and no cosine, so
// that what is drawn has the same bits everywhere.

#include <array>
#include <cmath>
#include <cstddef>

#include <timestep/checks.hpp>
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
    Orientation seen(const Orientation& body_to_world) const { return world_to_screen_ * body_to_world; }

    void grab(double x, double y) { x_ = x, y_ = y; }
    void drag(double x, double y) {
        const double faster = 2;  // rad per unit of the picture
        const Orientation before = world_to_screen_;
        world_to_screen_ = timestep::rotated_in_body(world_to_screen_, Place(0, 0, x - x_), faster);
        const Orientation sideways = world_to_screen_;
        world_to_screen_ = timestep::rotated(sideways, Place(y_ - y, 0, 0), faster);
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
                Face& face = add(i != marked ? soft : side > 0 ? orange : blue);
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
                Face& face = add(ring > 4 ? soft : sector < 6 ? orange : blue);
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
        const Matrix turned = view.seen(q).toRotationMatrix();
        std::array<bool, most_parts> drawn{};
        for (std::size_t n = 0; n < parts_; ++n) {
            std::size_t farthest = most_parts;
            const auto depth = [&](std::size_t part) { return turned.row(2).dot(centre_[part]); };
            for (std::size_t part = 0; part < parts_; ++part)
                if (!drawn[part] && (farthest == most_parts || depth(part) < depth(farthest))) farthest = part;
            drawn[farthest] = true;
            draw(p, turned, x, y, farthest);
        }
    }

private:
    using Matrix = timestep::Matrix3<double>;
    static constexpr std::size_t most_faces = 84, most_parts = 4;
    enum Paint { soft, blue, orange };
    static constexpr const char* look[] = {"soft", "first", "second"};
    struct Face {
        std::array<Place, 4> corners;  // counterclockwise seen from outside
        int count;
        std::size_t part;
        Paint paint;
    };

    void begin_part(const Place& centre) { centre_[parts_++] = centre; }
    Face& add(Paint paint) {
        Face& face = face_[faces_++];
        face.count = 0, face.part = parts_ - 1, face.paint = paint;
        return face;
    }

    // A drawing costs more than a face. So the faces of one paint are one drawing; above them light and shade, where
    // those that are equally lit are one.
    void draw(Picture& p, const Matrix& turned, double x, double y, std::size_t part) const {
        constexpr int levels = 60, hidden = 2 * levels;  // of light: steps that no eye sees
        std::array<int, most_faces> paint{}, light{};
        for (std::size_t i = 0; i < faces_; ++i) {
            const auto& [a, b, c, d] = face_[i].corners;
            const Place normal = turned * (b - a).cross(c - b).normalized();
            const double lit = normal.dot(Place(-0.48, 0.64, 0.6));  // from behind the reader's left shoulder
            const bool seen = face_[i].part == part && normal.z() > 0;
            paint[i] = seen ? face_[i].paint : hidden;
            light[i] = seen ? static_cast<int>(std::floor(levels * lit + 0.5)) : hidden;
        }
        for (const Paint each : {soft, blue, orange}) fill(p, turned, x, y, paint, each, look[each], 1);
        for (int level = -levels; level <= levels; ++level) {
            const double brighter = 1.0 * level / levels - 0.5;
            fill(p, turned, x, y, light, level, brighter > 0 ? "paper" : "ink",
                 brighter > 0 ? brighter : -0.35 * brighter);
        }
    }
    // The faces of this kind.
    void fill(Picture& p, const Matrix& turned, double x, double y, const std::array<int, most_faces>& kinds, int kind,
              const char* with, double strength) const {
        bool begun = false;
        for (std::size_t i = 0; i < faces_; ++i) {
            if (kinds[i] != kind) continue;
            if (!begun) p.ink(with, 1, strength);
            begun = true;
            for (int j = 0; j < face_[i].count; ++j) {
                const Place corner = turned * face_[i].corners[static_cast<std::size_t>(j)];
                j == 0 ? p.move(x + corner.x(), y + corner.y()) : p.line(x + corner.x(), y + corner.y());
            }
        }
        if (begun) p.fill();
    }

    std::array<Face, most_faces> face_{};
    std::array<Place, most_parts> centre_{};
    std::size_t faces_ = 0, parts_ = 0;
};

}  // namespace live
