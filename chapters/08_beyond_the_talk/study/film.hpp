#pragma once
// Convex bodies in perspective, shaded, as polygons for gnuplot. What looks away from the eye is
// left out; rows of bodies are drawn from the last to the first, so that a body hides what is
// behind it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "lab.hpp"
#include "solids.hpp"

namespace film {

constexpr int shades = 8;  // of each paint, dark to light, as in the palette of tumbling.gp

class Film {
public:
    Film(lab::Findings& out, const std::string& file)
        : table_(out.table(file, {"x", "y", "paint"})) {}

    // The eye looks along the world's y axis and downwards.
    void body(const std::vector<Face>& faces, const timestep::Quaternion<double>& q,
              const V& place) {
        const V eye(0, -9, 8), light = V(-0.5, -0.5, 0.9).normalized();
        const V ahead = (V(0, 3.4, 0) - eye).normalized(), up = V::UnitX().cross(ahead);
        for (const Face& face : faces) {
            const V a = face.corners[1] - face.corners[0], b = face.corners[2] - face.corners[1];
            const V normal = q * a.cross(b).normalized();
            if (normal.dot(eye - place - q * face.corners[0]) <= 0) continue;
            const double bright =
                std::clamp(0.25 + 0.75 * (0.5 + 0.5 * normal.dot(light)), 0.0, 0.999);
            if (started_) table_.gap();
            started_ = true;
            for (const V& corner : face.corners) {
                const V ray = place + q * corner - eye;
                const double far = ray.dot(ahead);
                table_.row({digits(ray.x() / far), digits(ray.dot(up) / far),
                            double(face.paint * shades + int(shades * bright))});
            }
        }
    }
    // The next bodies hide these.
    void row_ends() {
        table_.gap();
        table_.gap();
        started_ = false;
    }

private:
    static std::string digits(double value) {
        char text[24];
        std::snprintf(text, sizeof text, "%.4f", value);
        return text;
    }
    lab::Table& table_;
    bool started_ = false;
};

}  // namespace film
