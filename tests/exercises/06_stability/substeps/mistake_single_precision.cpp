#include "exercise.hpp"

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const float omega = std::sqrt(static_cast<float>(springs * stiffness / mass));
    const float least = omega * static_cast<float>(frame) / (2 * static_cast<float>(share));
    return std::max(1, static_cast<int>(std::ceil(least)));
}
