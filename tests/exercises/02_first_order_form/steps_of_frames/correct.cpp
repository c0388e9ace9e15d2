#include "exercise.hpp"

namespace division {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    std::vector<int> steps;
    double owed = 0;
    for (const double passed : frames) {
        owed += passed;
        const double due = std::floor(owed / step);
        steps.push_back(static_cast<int>(std::min<double>(due, most_steps)));
        owed = std::fmod(owed, step);
    }
    return steps;
}

}  // namespace division

namespace two_clocks {

std::vector<int> steps_of_frames(const std::vector<double>& frames, double step, int most_steps) {
    // The clock on the wall and the clock of the simulation, the latter in whole steps.
    double wall = 0, simulated = 0;
    std::vector<int> steps;
    for (const double passed : frames) {
        wall += passed;
        int count = 0;
        while (simulated + step <= wall) {
            simulated += step;
            ++count;
        }
        steps.push_back(count > most_steps ? most_steps : count);
    }
    return steps;
}

}  // namespace two_clocks
