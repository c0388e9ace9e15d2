#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double highest = 0;
    for (const double height : exact) highest = std::max(highest, std::fabs(height));
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        if (!(std::fabs(x[mark] - exact[mark]) <= accuracy * highest)) return false;
    return true;
}
