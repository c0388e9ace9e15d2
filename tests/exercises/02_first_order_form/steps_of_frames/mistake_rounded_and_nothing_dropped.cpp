#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        const int due = static_cast<int>(std::round(owed / step));
        const int count = std::min(due, most_steps);
        owed -= count * step;
        steps.push_back(count);
    }
    return steps;
}
