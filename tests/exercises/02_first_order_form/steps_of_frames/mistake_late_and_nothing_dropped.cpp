#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        int count = 0;
        for (; owed > step && count < most_steps; ++count) owed -= step;
        steps.push_back(count);
    }
    return steps;
}
