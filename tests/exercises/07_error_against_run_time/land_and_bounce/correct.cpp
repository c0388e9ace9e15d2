#include "exercise.hpp"

namespace again_for_the_rest {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const bool lies = s.x <= 0 && std::fabs(s.v) < 1e-9;
    if (lies) return {s.t + h, 0, 0};
    // The root that is not in the past, without a difference of nearly equal numbers.
    const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
    const double landing = s.v > 0 ? (s.v + impact) / g : 2 * s.x / (impact - s.v);
    if (landing > h) return {s.t + h, s.x + h * (s.v - g * h / 2), s.v - g * h};
    return land_and_bounce({s.t + landing, 0, e * impact}, g, e, h - landing);
}

}  // namespace again_for_the_rest

namespace bounded_number {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    // After so many bounces one with e below 1 is slower than anybody can see.
    for (int bounces = 0; bounces <= 2000; ++bounces) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
        const double fall = (s.v + impact) / g;
        if (fall > h) return {end, s.x + s.v * h - g * h * h / 2, s.v - g * h};
        h -= fall;
        s = {s.t + fall, 0, e * impact};
    }
    return {end, 0, 0};
}

}  // namespace bounded_number

namespace closed_form {

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

}  // namespace closed_form
