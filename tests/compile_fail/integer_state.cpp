// Whole numbers would round every step to nothing.
// error: timestep: a state holds real numbers: write 1.0 instead of 1
#include <timestep/state.hpp>

int main() {
#ifdef MISUSE
    const timestep::State start{0, 1, 0};
#else
    const timestep::State start{0, 1.0, 0};
#endif
    return start.x > 2;
}
