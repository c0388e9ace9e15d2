// A force that returns nothing.
// error: timestep: the acceleration must be what the position is: a number, or a vector of the same size
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/run.hpp>

struct Spring {
#ifdef MISUSE
    void acceleration(double) const {}
#else
    double acceleration(double x) const { return -x; }
#endif
};

int main() {
    timestep::run(timestep::semi_implicit_euler, Spring{}, timestep::State{0.0, 1.0, 0.0}, 0.1, 10);
}
