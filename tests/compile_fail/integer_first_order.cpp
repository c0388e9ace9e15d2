// Whole numbers would round every step to nothing, in a first-order system as well.
// error: timestep: a state holds real numbers: write 1.0 instead of 1
#include <timestep/state.hpp>

int main() {
#ifdef MISUSE
    const timestep::FirstOrder start{0, 1};
#else
    const timestep::FirstOrder start{0, 1.0};
#endif
    return start.y > 2;
}
