// Misuses that must not compile, one after the other, each below its name: with MISUSE defined the first error
// says what its line  // error:  promises; without, it compiles. These headers are read before each.
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/body_scene.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

using namespace timestep;

// ---- const term
// A const type is another type, and would not be known for rolling resistance or ground.
// error: timestep: the terms of a BodyScene are neither const nor references
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

// ---- ground before weight
// The ground carries what has pulled the body down: of a weight named after it, it would know
// nothing, and the body would sink.
// error: timestep: in a BodyScene Ground comes after Weight, which it has to carry
int main() {
    const Weight<double> weight(9.81);
    const Ground<double> ground(0.5);
#ifdef MISUSE
    const BodyScene scene(ground, weight);
#else
    const BodyScene scene(weight, ground);
#endif
    static_cast<void>(scene);
}

// ---- method and model swapped
// The method comes first, then the model.
// error: timestep: in run(method, model, start, h, steps) this method does not step this kind of state
int main() {
    const Spring spring(10.0);
    const State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    run(spring, semi_implicit_euler, start, 0.1, 10);
#else
    run(semi_implicit_euler, spring, start, 0.1, 10);
#endif
}

// ---- observer without state
// Whoever watches a run is handed each state.
// error: timestep: observe is called with each state, as in [](const auto& state) { }
int main() {
    int count = 0;
#ifdef MISUSE
    const auto observe = [&] { ++count; };
#else
    const auto observe = [&](const auto&) { ++count; };
#endif
    run(semi_implicit_euler, Spring(10.0), State{0.0, 1.0, 0.0}, 0.01, 600, observe);
}

// ---- rolling before ground
// What the ground carries is not known before the ground has acted.
// error: timestep: in a BodyScene RollingResistance comes after Ground, whose load it needs
int main() {
    const Ground<double> ground(0.5);
    const RollingResistance<double> rolling(0.01);
#ifdef MISUSE
    const BodyScene scene(rolling, ground);
#else
    const BodyScene scene(ground, rolling);
#endif
    static_cast<void>(scene);
}

// ---- step and steps swapped
// The length of a step comes first, then how many of them.
// error: timestep: in run(method, model, start, h, steps) steps is a whole number
int main() {
    const Spring spring(10.0);
    const State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    run(semi_implicit_euler, spring, start, 600, 0.01);
#else
    run(semi_implicit_euler, spring, start, 0.01, 600);
#endif
}

// ---- scene without forces
// A scene adds up forces; without any it has no acceleration.
// error: timestep: a scene needs at least one force
int main() {
#ifdef MISUSE
    const Scene<> scene;
#else
    const Scene<Spring<double>> scene(Spring(10.0));
#endif
    static_cast<void>(scene);
}
