#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double worst = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        worst = std::max(std::fabs(x[mark] - exact[mark]), worst);
    return worst <= accuracy * size;
}
