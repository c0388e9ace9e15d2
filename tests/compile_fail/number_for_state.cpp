// A run starts from a state, not from a position.
// error: timestep: a run starts from a State{t, x, v} or a FirstOrder{t, y}
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
#ifdef MISUSE
    const double start = 1.0;
#else
    const State start{0.0, 1.0, 0.0};
#endif
    run(semi_implicit_euler, Spring(10.0), start, 0.01, 10);
}
