#include "exercise.hpp"

// Swinging: z = omega h (c + i s), and R by its real and its imaginary part. Not swinging: the real
// z where R(z) = -1, by Newton-Raphson.
double longest_kutta_step(double omega, double zeta) {
    if (zeta >= 1) {
        double z = -2.5;
        for (int i = 0; i < 20; ++i) {
            const double R = 1 + z + z * z / 2 + z * z * z / 6, slope = 1 + z + z * z / 2;
            z -= (R + 1) / slope;
        }
        return -z / (omega * (zeta + std::sqrt(zeta - 1) * std::sqrt(zeta + 1)));
    }
    const double c = -zeta, s = std::sqrt(1 - zeta * zeta);
    const auto grows = [&](double r) {
        const double a = r * c, b = r * s;
        const double re = 1 + a + (a * a - b * b) / 2 + (a * a * a - 3 * a * b * b) / 6;
        const double im = b + a * b + (3 * a * a * b - b * b * b) / 6;
        return re * re + im * im > 1;
    };
    double low = 1.5, high = 3;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        (grows(middle) ? high : low) = middle;
    }
    return low / omega;
}
