#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    for (const double passed : frames)
        steps.push_back(std::min(static_cast<int>(passed / step), most_steps));
    return steps;
}
