#include "exercise.hpp"

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    // A pack holds 3 * width numbers, those of a lane `width` apart.
    const auto copy = [&](int from, int to) {
        for (int part = 0; part < 3; ++part)
            packs[3 * to + part] =
                packs[3 * from + part];
    };
    copy(n - 1, i);
    const int left = n - 1, used = (left + width - 1) / width;
    packs.resize(3 * width * used);
    for (int lane = left; lane < used * width; ++lane) copy(left - 1, lane);
    return packs;
}
