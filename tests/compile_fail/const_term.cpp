// A const type is another type, and would not be known for rolling resistance or ground.
// error: timestep: the terms of a BodyScene are neither const nor references
#include <timestep/rigid/body_scene.hpp>

using namespace timestep;

int main() {
    const Ground<double> ground(0.5);
    const RollingResistance<double> rolling(0.01);
#ifdef MISUSE
    const BodyScene<const RollingResistance<double>, Ground<double>> scene(rolling, ground);
#else
    const BodyScene<Ground<double>, RollingResistance<double>> scene(ground, rolling);
#endif
    static_cast<void>(scene);
}
