#include "exercise.hpp"

bool replay_fits(std::vector<double> x, std::vector<double> exact, double size, double accuracy) {
    return false;
}
