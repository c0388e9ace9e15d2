#include "exercise.hpp"

namespace complex_cable {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    // The cable as a complex number of length 1: its imaginary part is the sine.
    const std::complex<double> cable = std::polar(1.0, s.x);
    double rate = g * cable.imag() / length;
    rate += drag * length * s.v * std::fabs(s.v);
    return {s.v, -rate};
}

}  // namespace complex_cable

namespace per_angle {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    const double gravity = -(g / length) * std::sin(s.x);
    const double air = -drag * length * std::copysign(s.v * s.v, s.v);
    return {s.v, gravity + air};
}

}  // namespace per_angle

namespace quarter_turn {

std::array<double, 2> pendulum_rates(const State<double>& s, double g, double length, double drag) {
    // The sine is the cosine of what the angle lacks to a quarter turn.
    const double u = length * s.v, across = std::cos(std::numbers::pi / 2 - s.x);
    return {s.v, -(g * across + drag * u * std::fabs(u)) / length};
}

}  // namespace quarter_turn
