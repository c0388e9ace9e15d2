// A number where a model is due.
// error: timestep: a model needs a const member acceleration(), acceleration(x) or acceleration(x, v)
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

int main() {
#ifdef MISUSE
    const double model = 10.0;
#else
    const timestep::Spring model(10.0);
#endif
    timestep::run(timestep::semi_implicit_euler, model, timestep::State{0.0, 1.0, 0.0}, 0.1, 10);
}
