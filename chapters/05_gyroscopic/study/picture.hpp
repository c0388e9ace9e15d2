#pragma once
// Solid bodies as polygons on a screen. The bodies are convex: what looks away from the eye is
// hidden, and the rest hides nothing.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <timestep/rigid/rotation.hpp>

#include "lab.hpp"

namespace picture {

using V = timestep::Vector3<double>;
using Orientation = timestep::Quaternion<double>;

// The paints of the palette in films.gp. Of polygons that overlap, gnuplot puts the one with the
// lower number in front: bodies before their shadow before the floor.
constexpr int shades = 5;
enum Paint { first = 0, second = shades, third = 2 * shades, shadow = 3 * shades, line, ground };

struct Face {
    std::vector<V> corners;  // counterclockwise seen from outside, body coordinates
    int paint;
};

inline double degrees(double angle) { return angle * std::acos(-1.0) / 180; }

// The eye looks along the world's y axis and a little downwards, from far away.
struct Camera {
    double down = degrees(18);
    V to_eye() const { return {0, -std::cos(down), std::sin(down)}; }
    V up() const { return {0, std::sin(down), std::cos(down)}; }
};

// One film: polygons frame by frame, a blank line after each and two after the last of a frame.
class Film {
public:
    Film(lab::Findings& out, const std::string& file) : table_(out.table(file, {"x", "y", "paint"})) {}

    void polygon(const std::vector<V>& corners, const V& origin, double shift, int paint) {
        if (started_) table_.gap();
        started_ = true;
        for (const V& c : corners)
            table_.row({digits((c - origin).x() + shift), digits(camera_.up().dot(c - origin)), double(paint)});
    }
    void frame_ends() {
        table_.gap();
        table_.gap();
        started_ = false;
    }

    // A body at `x`, drawn where `origin` is the middle of its panel.
    void body(const std::vector<Face>& faces, const Orientation& q, const V& x, const V& origin, double shift) {
        const V light = V(-0.5, -0.6, 0.8).normalized();
        for (const Face& face : faces) {
            const V a = face.corners[1] - face.corners[0], b = face.corners[2] - face.corners[1];
            const V normal = (q * a.cross(b)).normalized();
            if (normal.dot(camera_.to_eye()) <= 0) continue;
            std::vector<V> corners;
            for (const V& c : face.corners) corners.push_back(x + q * c);
            const double bright = std::clamp(0.5 + 0.5 * normal.dot(light), 0.0, 0.999);
            polygon(corners, origin, shift, face.paint + static_cast<int>(shades * bright));
        }
    }

    // A square of the plane z = 0 around the origin with the lines of a grid that is fixed in the
    // world.
    void floor(const V& origin, double half, double spacing, double shift) {
        const auto strip = [&](double x1, double x2, double y1, double y2, int paint) {
            polygon({{x1, y1, 0}, {x2, y1, 0}, {x2, y2, 0}, {x1, y2, 0}}, origin, shift, paint);
        };
        const double x = origin.x(), y = origin.y(), thin = half / 150;
        strip(x - half, x + half, y - half, y + half, ground);
        for (double k = std::ceil((x - half) / spacing) * spacing; k <= x + half; k += spacing)
            strip(std::max(k - thin, x - half), std::min(k + thin, x + half), y - half, y + half, line);
        for (double k = std::ceil((y - half) / spacing) * spacing; k <= y + half; k += spacing)
            strip(x - half, x + half, std::max(k - 2 * thin, y - half), std::min(k + 2 * thin, y + half), line);
    }

private:
    static std::string digits(double value) {
        char text[24];
        std::snprintf(text, sizeof text, "%.3f", value);
        return text;
    }
    lab::Table& table_;
    Camera camera_;
    bool started_ = false;
};

// A box with sides a, b, c; the two ends along y have paints of their own.
inline std::vector<Face> box(double a, double b, double c) {
    const auto at = [&](int x, int y, int z) { return V(x * a / 2, y * b / 2, z * c / 2); };
    return {{{at(1, -1, -1), at(1, 1, -1), at(1, 1, 1), at(1, -1, 1)}, third},
            {{at(-1, -1, -1), at(-1, -1, 1), at(-1, 1, 1), at(-1, 1, -1)}, third},
            {{at(-1, 1, -1), at(-1, 1, 1), at(1, 1, 1), at(1, 1, -1)}, first},
            {{at(-1, -1, -1), at(1, -1, -1), at(1, -1, 1), at(-1, -1, 1)}, second},
            {{at(-1, -1, 1), at(1, -1, 1), at(1, 1, 1), at(-1, 1, 1)}, third},
            {{at(-1, -1, -1), at(-1, 1, -1), at(1, 1, -1), at(1, -1, -1)}, third}};
}

// A capsule along z, one half of it in the first paint and the other in the second, so that its
// spin shows; one end in the third.
inline std::vector<Face> capsule(double radius, double half_length) {
    constexpr int sectors = 14, rings = 3;
    std::vector<std::array<double, 2>> profile;  // distance from the axis, z; from below
    for (int i = 0; i <= rings; ++i)
        profile.push_back({radius * std::sin(degrees(90.0 * i / rings)),
                           -half_length - radius * std::cos(degrees(90.0 * i / rings))});
    for (int i = 0; i <= rings; ++i)
        profile.push_back(
            {radius * std::cos(degrees(90.0 * i / rings)), half_length + radius * std::sin(degrees(90.0 * i / rings))});
    const auto at = [&](std::size_t i, int sector) {
        const double phi = degrees(360.0 * sector / sectors);
        return V(profile[i][0] * std::cos(phi), profile[i][0] * std::sin(phi), profile[i][1]);
    };
    std::vector<Face> faces;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        for (int s = 0; s < sectors; ++s) {
            // At the poles a face is a triangle, and its third corner comes first.
            std::vector<V> corners{at(i, s + 1), at(i + 1, s + 1), at(i + 1, s), at(i, s)};
            if (i == 0) corners.pop_back();
            if (i + 2 == profile.size()) corners.erase(corners.begin() + 1);
            const int paint = i + 2 >= profile.size() - 1 ? third : s < sectors / 2 ? first : second;
            faces.push_back({corners, paint});
        }
    return faces;
}

}  // namespace picture
