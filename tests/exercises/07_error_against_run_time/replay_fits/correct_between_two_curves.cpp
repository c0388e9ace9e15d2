#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    const double limit = accuracy * size;
    std::size_t good = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        if (x[mark] - exact[mark] >= -limit && x[mark] - exact[mark] <= limit) ++good;
    return good == exact.size();
}
