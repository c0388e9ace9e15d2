#include <cstdio>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const Projectile ball(-8.0);
    const State end = run(semi_implicit_euler, ball, State{0, 0.0, 4.0}, 0.5, 2);
    std::printf("%g %g\n", end.t, end.x);
}
