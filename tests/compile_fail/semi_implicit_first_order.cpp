// Semi-implicit Euler needs to know which unknown is the position and which the velocity.
// error: timestep: in run(method, model, start, h, steps) this method does not step this kind of state
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const auto decay = [](double, double y) { return -y; };
#ifdef MISUSE
    const SemiImplicitEuler method;
#else
    const ExplicitEuler method;
#endif
    run(method, decay, FirstOrder{0.0, 1.0}, 0.1, 10);
}
