#include "exercise.hpp"

// From the longest step that is allowed.
int substeps(double mass, int springs, double stiffness, double frame, double share) {
    if (springs == 0 || stiffness == 0) return 1;
    const double longest = 2 * share * std::sqrt(mass / (springs * stiffness));
    const int whole = static_cast<int>(frame / longest);
    return whole * longest < frame ? whole + 1 : whole;
}
