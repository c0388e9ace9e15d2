#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    if (x.size() != exact.size()) return false;
    double squares = 0;
    for (std::size_t mark = 0; mark < x.size(); ++mark)
        squares += (x[mark] - exact[mark]) * (x[mark] - exact[mark]);
    return std::sqrt(squares / double(x.size())) <= accuracy * size * (1 + 1e-12);
}
