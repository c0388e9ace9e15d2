#include "exercise.hpp"

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const bool lies = s.x <= 0 && std::fabs(s.v) < 1e-9;
    if (lies) return {s.t + h, 0, 0};
    // The root that is not in the past, without a difference of nearly equal numbers.
    const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
    const double landing = s.v > 0 ? (s.v + impact) / g : 2 * s.x / (impact - s.v);
    if (landing > h) return {s.t + h, s.x + h * (s.v - g * h / 2), s.v - g * h};
    return land_and_bounce({s.t + landing, 0, e * impact}, g, e, h - landing);
}
