#include "exercise.hpp"

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    const int left = n - 1, old_lane = left % width, old_pack = left / width;
    for (int part = 0; part < 3; ++part) {
        double* const last_row = packs.data() + (3 * old_pack + part) * width;
        packs[(3 * (i / width) + part) * width + i % width] = last_row[old_lane];
        if (old_lane > 0) std::fill(last_row + old_lane, last_row + width, last_row[old_lane - 1]);
    }
    if (old_lane == 0) packs.erase(packs.end() - 3 * width, packs.end());
    return packs;
}
