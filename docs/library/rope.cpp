#include <iostream>

#include <Eigen/Core>
#include <timestep/rope.hpp>

int main() {
    using Eigen::Vector2d;
    const timestep::Projectile gravity(Vector2d(0, -9.81));  // m/s²
    const Vector2d top(0, 2), along(1, 0);                   // m; it begins level
    timestep::Rope rope(top, along, 20, 0.05, gravity);      // 20 links of 0.05 m
    for (int n = 0; n < 60; ++n) rope.step(1.0 / 60, 8);     // a second, 8 sweeps a step
    std::cout << "its end is at (" << rope.points().back().x.transpose() << ") m\n"
              << "and it is " << 100 * rope.stretch() << " % too long\n";
}
