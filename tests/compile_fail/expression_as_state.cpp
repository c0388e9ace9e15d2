// An Eigen expression refers to its operands and would outlive them.
// error: timestep: a state holds vectors, not Eigen expressions of them: State<Eigen::Vector3d>
#include <Eigen/Core>
#include <timestep/state.hpp>

int main() {
    const Eigen::Vector3d x(1, 2, 3);
#ifdef MISUSE
    const timestep::State<decltype(x + x)> start{0.0, x + x, x + x};
#else
    const timestep::State start{0.0, x + x, x + x};
#endif
    return start.x.x() > 2;
}
