// A first-order system is a function of t and y.
// error: timestep: a first-order system needs f(t, y)
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/run.hpp>

using namespace timestep;

int main() {
#ifdef MISUSE
    const auto f = [](double y) { return -y; };
#else
    const auto f = [](double, double y) { return -y; };
#endif
    run(explicit_euler, f, FirstOrder{0.0, 1.0}, 0.1, 10);
}
