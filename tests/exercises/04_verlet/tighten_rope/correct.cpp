#include "exercise_eigen.hpp"

namespace centre {

// Both ends are placed anew, from the centre of mass, which a pull between them cannot move.
std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    if (wa + wb == 0 || (b - a).squaredNorm() <= length * length) return {a, b};
    const double share = wa / (wa + wb);  // of a: how far it is from the centre
    const Vector3d centre = (1 - share) * a + share * b, along = (b - a).normalized();
    return {centre - share * length * along, centre + (1 - share) * length * along};
}

}  // namespace centre

namespace fractions {

std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const double distance = (a - b).norm();
    const double too_long = std::max(0.0, distance - length);
    if (too_long == 0) return {a, b};
    const Vector3d inwards = too_long / distance * (b - a);
    if (wa > 0) a += inwards / (1 + wb / wa);
    if (wb > 0) b -= inwards / (1 + wa / wb);
    return {a, b};
}

}  // namespace fractions

namespace what_is_left_to_a {

// The share of b, and what is left to a: of a heavy a that is nothing but roundoff.
std::array<Vector3d, 2> tighten_rope(Vector3d a, Vector3d b, double wa, double wb, double length) {
    const Vector3d apart = b - a;
    const double distance = apart.norm();
    if (distance <= length || wa + wb == 0) return {a, b};
    const Vector3d pull = (1 - length / distance) * apart;
    const double share = wb / (wa + wb);
    return {a + (1 - share) * pull, b - share * pull};
}

}  // namespace what_is_left_to_a
