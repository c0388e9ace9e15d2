#include <cstdio>

#include <timestep/gyroscopic.h>

int main() {
    // One over the moments, 1/(kg m²), as engines keep them; ω in the body's axes, rad/s.
    const gyroscopic_bodyf box = gyroscopic_from_inverse_momentsf(120.0f, 60.0f, 46.0f);
    float omega[3] = {0.1f, 8.0f, 0.1f};
    for (int n = 0; n < 60; ++n) gyroscopic_calm_half_stepf(&box, omega, 1.0f / 60);
    std::printf("after a second: ω = (%.3f, %.3f, %.3f) rad/s\n", omega[0], omega[1], omega[2]);
}
