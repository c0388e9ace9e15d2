#include "exercise.hpp"

namespace count_up {

// One after another, until the step is short enough. Squares need no root.
int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double limit = 4 * share * share * mass;
    for (int n = 1;; ++n) {
        const double h = frame / n;
        if (springs * stiffness * h * h <= limit) return n;
    }
}

}  // namespace count_up

namespace longest_step {

// From the longest step that is allowed.
int substeps(double mass, int springs, double stiffness, double frame, double share) {
    if (springs == 0 || stiffness == 0) return 1;
    const double longest = 2 * share * std::sqrt(mass / (springs * stiffness));
    const int whole = static_cast<int>(frame / longest);
    return whole * longest < frame ? whole + 1 : whole;
}

}  // namespace longest_step
