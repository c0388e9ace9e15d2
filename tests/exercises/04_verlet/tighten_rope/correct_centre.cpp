#include "exercise_eigen.hpp"

// Both ends are placed anew, from the centre of mass, which a pull between them cannot move.
std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    if (wa + wb == 0 || (b - a).squaredNorm() <= length * length) return {a, b};
    const double share = wa / (wa + wb);  // of a: how far it is from the centre
    const Vector3d centre = (1 - share) * a + share * b, along = (b - a).normalized();
    return {centre - share * length * along, centre + (1 - share) * length * along};
}
