#include "exercise.hpp"

int substeps(double mass, int springs, double stiffness, double frame, double share) {
    const double omega = std::sqrt(springs * stiffness / mass);
    return std::max(1, static_cast<int>(std::ceil(omega * frame / 2)));
}
