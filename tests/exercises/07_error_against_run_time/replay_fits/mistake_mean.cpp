#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double sum = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark) sum += std::fabs(x[mark] - exact[mark]);
    return sum / double(x.size()) <= accuracy * size * (1 + 1e-12);
}
