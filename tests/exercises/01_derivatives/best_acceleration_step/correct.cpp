#include "exercise.hpp"

namespace newton {

// Newton–Raphson on the slope of the bound, which never halves the step more than once at a time.
double best_acceleration_step(double noise, double snap) {
    double h = 1;
    for (int i = 0; i < 500; ++i) {
        const double slope = snap / 6 * h - 8 * noise / (h * h * h);
        const double bend = snap / 6 + 24 * noise / (h * h * h * h);
        h = std::max(h - slope / bend, h / 2);
    }
    return h;
}

}  // namespace newton

namespace two_roots {

double best_acceleration_step(double noise, double snap) {
    return std::sqrt(std::sqrt(48 * noise / snap));
}

}  // namespace two_roots
