// Two springs whose places are vectors: in space, and in a row.

#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/spring.hpp>

#include "springs.hpp"

using namespace timestep;

namespace contest {

Scene spring_3d() {
    const State start{0, Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0.6 * hertz, 0.2 * hertz)};
    return spring_scene("spring_3d", "a ball on an elastic in space", 1, Spring(hertz), start);
}

// A heavy mass on a soft spring carries a light one on a hard spring. Almost all of the motion is
// slow.
Scene two_time_scales() {
    const CoupledSprings row(Eigen::Vector2d(1, 0.01), Eigen::Vector3d(hertz * hertz, 1e4, 0));
    const Eigen::Vector2d slow = row.modes().col(0) / row.modes()(0, 0);
    const Eigen::Vector2d fast = row.modes().col(1) / row.modes().col(1).norm();
    const State start{0, Eigen::Vector2d(slow + 1e-3 * fast), Eigen::Vector2d(0, 0)};
    return spring_scene("two_time_scales", "a slow oscillation, and a fast shiver of a thousandth of it", 1, row,
                        start);
}

}  // namespace contest
