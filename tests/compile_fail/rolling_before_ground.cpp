// What the ground carries is not known before the ground has acted.
// error: timestep: in a BodyScene RollingResistance comes after Ground, whose load it needs
#include <timestep/rigid/body_scene.hpp>

int main() {
    const timestep::Ground<double> ground(0.5);
    const timestep::RollingResistance<double> rolling(0.01);
#ifdef MISUSE
    const timestep::BodyScene scene(rolling, ground);
#else
    const timestep::BodyScene scene(ground, rolling);
#endif
    static_cast<void>(scene);
}
