#include "exercise.hpp"

static State<double> fly(const State<double>& s, double g, double h) {
    return {s.t + h, s.x + s.v * h - g * h * h / 2, s.v - g * h};
}
State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    // How many bounces there are is known at once: no loop.
    const double impact = std::sqrt(s.v * s.v + 2 * g * s.x), landing = (s.v + impact) / g;
    if (h < landing) return fly(s, g, h);
    const State<double> rest{s.t + h, 0, 0};
    const double since = h - landing, first = 2 * e * impact / g;
    if (first == 0) return rest;
    State<double> bounced{s.t + h, 0, e * impact};
    double into_flight = std::fmod(since, first);
    if (e < 1) {
        const double all = first / (1 - e);
        if (since >= all) return rest;
        const double bounces = std::floor(std::log1p(-since / all) / std::log(e));
        into_flight = since - all * (1 - std::pow(e, bounces));
        bounced.v *= std::pow(e, bounces);
    }
    bounced.t -= into_flight;
    return fly(bounced, g, into_flight);
}
