// Every solver with every inertia: in `double` here, and in `float` by the file next to this one.
// (Each is compiled by itself, as the compiler needs much memory for them.)

#include "extreme_bodies.hpp"

namespace extremes {

std::vector<Cell> of_bodies() {
    std::vector<Cell> cells = of_bodies_in<double>();
    for (const auto& more : {of_bodies_in<float>(), of_balls()}) cells.insert(cells.end(), more.begin(), more.end());
    return cells;
}

}  // namespace extremes
