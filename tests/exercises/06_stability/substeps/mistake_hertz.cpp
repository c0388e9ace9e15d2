#include "exercise.hpp"

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double frequency = std::sqrt(springs * stiffness / mass) / (2 * std::numbers::pi);
    return std::max(1, static_cast<int>(std::ceil(frequency * frame / (2 * share))));
}
