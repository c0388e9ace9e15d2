#include "exercise.hpp"

int best_gap(double frame, double noise, double jerk, int most) {
    const auto worst = [&](int frames) {
        const double gap = frames * frame;
        return jerk * gap * gap / 6 + 2 * noise / gap;
    };
    int frames = 1;
    while (frames < most && worst(frames + 1) < worst(frames)) ++frames;
    return frames;
}
