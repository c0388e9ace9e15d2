// A position in space and a velocity in the plane.
// error: timestep: position and velocity are two numbers, or two vectors of one size
#include <Eigen/Core>
#include <timestep/state.hpp>

int main() {
    const Eigen::Vector3d x(1, 2, 3);
#ifdef MISUSE
    const timestep::State start{0.0, x, Eigen::Vector2d(1, 2)};
#else
    const timestep::State start{0.0, x, Eigen::Vector3d(1, 2, 3)};
#endif
    return start.x.x() > 2;
}
