#include "exercise.hpp"

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        const int due = static_cast<int>(owed / step);
        steps.push_back(std::min(due, most_steps));
        owed = due > most_steps ? 0 : owed - due * step;
    }
    return steps;
}
