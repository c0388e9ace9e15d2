#include <iostream>

#include <timestep/difference_error.hpp>
#include <timestep/differences.hpp>

int main() {
    const auto height = [](double t) { return 20 - 4.905 * t * t; };  // m, a stone that falls
    const double v = timestep::central_difference(height, 1.0, 0.1);  // at 1 s, h = 0.1 s
    std::cout << "it falls at " << -v << " m/s\n";

    const double noise = 1e-4, third = 2;  // positions are off by up to 0.1 mm; |f‴| ≤ 2 m/s³
    const double h = timestep::best_step(timestep::central_difference, noise, third);
    std::cout << "of a noisy track take every " << h << " s\n";
}
