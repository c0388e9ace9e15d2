// Gravity as a whole number.
// error: timestep: parameters are real numbers: write 1.0 instead of 1
#include <timestep/models/projectile.hpp>

int main() {
#ifdef MISUSE
    const timestep::Projectile ball(-10);
#else
    const timestep::Projectile ball(-10.0);
#endif
    return ball.gravity > 0;
}
