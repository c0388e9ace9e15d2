// With whole numbers for the moments the inertia would be reckoned in whole numbers.
// error: timestep: parameters are real numbers: write 1.0 instead of 1
#include <timestep/rigid/inertia.hpp>

int main() {
#ifdef MISUSE
    const timestep::PrincipalInertia inertia(1, 2, 2);
#else
    const timestep::PrincipalInertia inertia(1.0, 2.0, 2.0);
#endif
    return inertia.moments.x() > 2;
}
