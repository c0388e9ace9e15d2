// Rolling resistance needs a ground to roll on: without one it would do nothing.
// error: timestep: in a BodyScene RollingResistance comes after Ground, whose load it needs
#include <timestep/rigid/body_scene.hpp>

int main() {
    const timestep::Weight<double> weight(9.81);
    const timestep::RollingResistance<double> rolling(0.01);
#ifdef MISUSE
    const timestep::BodyScene scene(weight, rolling);
#else
    const timestep::BodyScene scene(weight, timestep::Ground<double>(0.5), rolling);
#endif
    static_cast<void>(scene);
}
