// With a whole number for ω the spring would compute in whole numbers.
// error: timestep: parameters are real numbers: write 1.0 instead of 1
#include <timestep/models/spring.hpp>

int main() {
#ifdef MISUSE
    const timestep::Spring spring(10);
#else
    const timestep::Spring spring(10.0);
#endif
    return spring.omega > 20;
}
