#include "exercise.hpp"

namespace row_by_row {

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

}  // namespace row_by_row

namespace unpacked {

std::vector<double> despawn(std::vector<double> packs, int width, int n, int i) {
    // Out of the packs, an ordinary list of bodies, and back into packs.
    std::vector<std::array<double, 3>> bodies;
    for (int b = 0; b < n; ++b) {
        const double* const x = &packs[b / width * width * 3 + b % width];
        bodies.push_back({x[0], x[width], x[2 * width]});
    }
    std::swap(bodies[i], bodies.back());
    bodies.pop_back();
    std::vector<double> result;
    for (int first = 0; first < n - 1; first += width)
        for (std::size_t part = 0; part < 3; ++part)
            for (int lane = first; lane < first + width; ++lane) result.push_back(bodies[std::min(lane, n - 2)][part]);
    return result;
}

}  // namespace unpacked
