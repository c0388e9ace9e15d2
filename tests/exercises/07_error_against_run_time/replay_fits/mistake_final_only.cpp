#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    return std::fabs(x.back() - exact.back()) <= accuracy * size;
}
