// The method comes first, then the model.
// error: timestep: in run(method, model, start, h, steps) this method does not step this kind of state
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const Spring spring(10.0);
    const State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    run(spring, semi_implicit_euler, start, 0.1, 10);
#else
    run(semi_implicit_euler, spring, start, 0.1, 10);
#endif
}
