#include "exercise.hpp"

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
            for (int lane = first; lane < first + width; ++lane)
                result.push_back(bodies[std::min(lane, n - 2)][part]);
    return result;
}
