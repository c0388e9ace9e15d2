#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    for (std::size_t mark = 0; mark < x.size(); ++mark) {
        if (!std::isfinite(x[mark])) continue;
        if (std::fabs(x[mark] - exact[mark]) > accuracy * size) return false;
    }
    return true;
}
