#include "exercise.hpp"

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
