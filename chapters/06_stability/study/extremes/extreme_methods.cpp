// Every method in every scene: in `double` here, and in `float` by the file next to this one. (Each
// is compiled by itself, as the compiler needs much memory for them.)

#include "extreme_methods.hpp"

namespace extremes {

std::vector<Cell> of_methods() {
    std::vector<Cell> cells = of_methods_in<double>();
    for (const Cell& cell : of_methods_in<float>()) cells.push_back(cell);
    return cells;
}

}  // namespace extremes
