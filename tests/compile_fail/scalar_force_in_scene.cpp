// Gravity in a scene is a vector where the position is one, as it is alone.
// error: timestep: the acceleration must be what the position is: a number, or a vector of the same size
#include <Eigen/Core>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

using namespace timestep;

int main() {
    const State start{0.0, Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0)};
#ifdef MISUSE
    const Scene hung{Spring(2.0), Projectile(-9.81)};
#else
    const Scene hung{Spring(2.0), Projectile(Eigen::Vector3d(0, 0, -9.81))};
#endif
    run(semi_implicit_euler, hung, start, 0.01, 10);
}
