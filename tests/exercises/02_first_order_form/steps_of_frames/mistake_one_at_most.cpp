#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        steps.push_back(owed >= step ? 1 : 0);
        owed = std::fmod(owed, step);
    }
    return steps;
}
