#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += std::min(passed, most_steps * step);
        const int due = static_cast<int>(owed / step);
        steps.push_back(std::min(due, most_steps));
        owed = std::fmod(owed, step);
    }
    return steps;
}
