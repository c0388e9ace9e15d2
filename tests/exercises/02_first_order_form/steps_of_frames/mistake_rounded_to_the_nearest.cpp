#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        const double due = std::round(owed / step);
        steps.push_back(static_cast<int>(std::min<double>(due, most_steps)));
        owed = std::fmod(owed, step);
    }
    return steps;
}
