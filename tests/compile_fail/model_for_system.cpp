// A model of a body is no first-order system, which knows neither position nor velocity.
// error: timestep: a first-order system needs f(t, y)
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
    const Spring spring(10.0);
#ifdef MISUSE
    run(runge_kutta_4, spring, FirstOrder{0.0, 1.0}, 0.1, 10);
#else
    run(runge_kutta_4, spring, State{0.0, 1.0, 0.0}, 0.1, 10);
#endif
}
