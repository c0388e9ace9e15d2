// The length of a step comes first, then how many of them.
// error: timestep: in run(method, model, start, h, steps) steps is a whole number
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const Spring spring(10.0);
    const State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    run(semi_implicit_euler, spring, start, 600, 0.01);
#else
    run(semi_implicit_euler, spring, start, 0.01, 600);
#endif
}
