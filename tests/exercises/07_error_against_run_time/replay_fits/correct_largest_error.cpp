#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    // The largest error, NaN counted as infinite.
    double worst = x.size() == exact.size() ? 0 : std::numeric_limits<double>::infinity();
    for (std::size_t mark = 0; mark < std::min(x.size(), exact.size()); ++mark) {
        const double error = std::fabs(x[mark] - exact[mark]);
        worst =
            std::isfinite(error) ? std::max(worst, error) : std::numeric_limits<double>::infinity();
    }
    return worst <= accuracy * size;
}
