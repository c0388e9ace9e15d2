#include "exercise.hpp"

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
