#include <Eigen/Core>
#include <cstdio>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const Projectile ball(Eigen::Vector2d(0, -8));
    const State end = run(explicit_euler, ball, State{0, Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 4)}, 0.5, 2);
    std::printf("%g %g %g\n", end.t, end.x.x(), end.x.y());
}
