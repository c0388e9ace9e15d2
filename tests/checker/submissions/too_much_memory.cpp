// velocity_now too_much_memory: asked for more memory
#include "exercise.hpp"

double velocity_now(double x0, double x1, double x2, double h) {
    std::vector<std::vector<double>> history;
    for (std::size_t size = 1'000'000;; size *= 4) history.emplace_back(size, x0);
    return (x2 - x1) / h;
}
