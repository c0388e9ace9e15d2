#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    float owed = 0;
    for (const double passed : frames) {
        owed += static_cast<float>(passed);
        int count = 0;
        for (; owed >= static_cast<float>(step); owed -= static_cast<float>(step))
            if (count < most_steps) ++count;
        steps.push_back(count);
    }
    return steps;
}
