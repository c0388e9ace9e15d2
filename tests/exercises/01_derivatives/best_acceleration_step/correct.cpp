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

double best_acceleration_step(double noise, double snap) { return std::sqrt(std::sqrt(48 * noise / snap)); }

}  // namespace two_roots

namespace three_parts {

// The search that knows no slope: the error of two steps between the ends says which third to drop.
double best_acceleration_step(double noise, double snap) {
    const auto worst = [&](double logarithm) {
        const double h = std::exp(logarithm);
        return snap * h * h / 12 + 4 * noise / (h * h);
    };
    double low = -30, high = 30;
    for (int i = 0; i < 200; ++i) {
        const double one = low + (high - low) / 3, other = high - (high - low) / 3;
        if (worst(one) < worst(other))
            high = other;
        else
            low = one;
    }
    return std::exp((low + high) / 2);
}

}  // namespace three_parts
