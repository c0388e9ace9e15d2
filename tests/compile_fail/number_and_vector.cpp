// A position with three coordinates and a velocity with one.
// error: timestep: position and velocity are two numbers, or two vectors of one size
#include <Eigen/Core>
#include <timestep/state.hpp>

int main() {
    const Eigen::Vector3d x(1, 2, 3);
#ifdef MISUSE
    const timestep::State start{0.0, x, 0.0};
#else
    const timestep::State start{0.0, x, Eigen::Vector3d::Zero()};
#endif
    return start.x.x() > 2;
}
