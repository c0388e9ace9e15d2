#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        const int count = std::min(static_cast<int>(owed / step), most_steps);
        steps.push_back(count);
        owed -= count * step;
    }
    return steps;
}
