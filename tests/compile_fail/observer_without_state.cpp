// Whoever watches a run is handed each state.
// error: timestep: observe is called with each state, as in [](const auto& state) { }
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    int count = 0;
#ifdef MISUSE
    const auto observe = [&] { ++count; };
#else
    const auto observe = [&](const auto&) { ++count; };
#endif
    run(semi_implicit_euler, Spring(10.0), State{0.0, 1.0, 0.0}, 0.01, 600, observe);
}
