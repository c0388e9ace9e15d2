// turn_exactly wrong: which returned {x 0.25, y 0.125, z 1, w 0.5}
#include "exercise_eigen.hpp"

Quaterniond turn_exactly(const Quaterniond&, const Vector3d&, double) {
    return Quaterniond(0.5, 0.25, 0.125, 1);
}
