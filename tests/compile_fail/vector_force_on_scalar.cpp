// Gravity is a number where the position is one.
// error: timestep: the acceleration must be what the position is: a number, or a vector of the same size
#include <Eigen/Core>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    const Projectile ball(Eigen::Vector3d(0, 0, -9.81));
#else
    const Projectile ball(-9.81);
#endif
    run(explicit_euler, ball, start, 0.01, 10);
}
