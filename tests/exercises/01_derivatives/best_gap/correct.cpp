#include "exercise.hpp"

namespace every_gap {

int best_gap(double frame, double noise, double jerk, int most) {
    int best = most;
    double least = std::numeric_limits<double>::infinity();
    for (int frames = most; frames >= 1; --frames) {
        const double gap = frames * frame;
        const double worst = jerk * gap * gap / 24 + 2 * noise / gap;
        if (worst <= least) {
            least = worst;
            best = frames;
        }
    }
    return best;
}

}  // namespace every_gap

namespace two_neighbours {

// The optimal step size in closed form lies between two whole numbers: which of them?
int best_gap(double frame, double noise, double jerk, int most) {
    if (jerk == 0) return most;
    const double ideal = 2 * std::cbrt(3 * noise / jerk) / frame;
    if (ideal >= most) return most;
    const int below = static_cast<int>(ideal);
    if (below == 0) return 1;
    // From one gap to the next, n to n + 1, the truncation grows by (2n + 1) parts, and the noise
    // falls by 1/n − 1/(n + 1): equal where ideal³ = n (n + 1/2)(n + 1).
    const double n = below;
    return ideal * ideal * ideal > n * (n + 0.5) * (n + 1) ? below + 1 : below;
}

}  // namespace two_neighbours
