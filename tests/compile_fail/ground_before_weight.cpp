// The ground carries what has pulled the body down: of a weight named after it, it would know
// nothing, and the body would sink.
// error: timestep: in a BodyScene Ground comes after Weight, which it has to carry
#include <timestep/rigid/body_scene.hpp>

int main() {
    const timestep::Weight<double> weight(9.81);
    const timestep::Ground<double> ground(0.5);
#ifdef MISUSE
    const timestep::BodyScene scene(ground, weight);
#else
    const timestep::BodyScene scene(weight, ground);
#endif
    static_cast<void>(scene);
}
