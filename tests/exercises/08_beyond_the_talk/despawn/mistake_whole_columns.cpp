#include "exercise.hpp"

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const int lanes = (n + width - 1) / width * width;
    // A pack holds 3 * width numbers, those of a lane `width` apart.
    const auto copy = [&](int from, int to) {
        for (int part = 0; part < 3; ++part)
            packs[part * lanes + to] =
                packs[part * lanes + from];
    };
    copy(n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    if (left > 0)
        for (int lane = left; lane < used * width; ++lane) copy(left - 1, lane);
    packs.resize(3 * width * used);
    return packs;
}
