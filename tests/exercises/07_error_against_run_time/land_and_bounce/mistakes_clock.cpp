// The clock, and what is left of the step.

// Says: The ball ends the step on the ground, with the speed of its bounce: the rest of the step is lost.
// Hint: It landed before the end. For how long does it rise already?
namespace rest_of_step_lost {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return landed(s, g, h, [&](double impact, double) {
        return State<double>{s.t + h, 0, e * impact};
    });
}

}  // namespace rest_of_step_lost

// Says: After the bounce the ball flies for a whole step, and not only for what is left of this one.
// Hint: Subtract the time until the bounce.
namespace whole_step_again {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return landed(s, g, h, [&](double impact, double) { return fly({s.t, 0, e * impact}, g, h); });
}

}  // namespace whole_step_again

// Says: The clock is only moved on by what was left of the step after the last bounce.
// Hint: A step ends at s.t + h, whatever happens within it.
namespace clock_of_the_rest {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    double left = h;
    for (int bounces = 0; bounces < 5000; ++bounces) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
        const double fall = (s.v + impact) / g;
        if (fall > left)
            return {s.t + left, s.x + s.v * left - g * left * left / 2, s.v - g * left};
        left -= fall;
        s.x = 0;
        s.v = e * impact;
        if (2 * s.v / g <= (1 - e) * left) return {end, 0, 0};
    }
    return {end, 0, 0};
}

}  // namespace clock_of_the_rest

// Says: The clock is not moved on.
// Hint: The state after the step is that of the time s.t + h.
namespace clock_stands {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    State<double> end = all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                                    [&](double v, double left) { return is_over(v, g, e, left); });
    end.t = s.t;
    return end;
}

}  // namespace clock_stands

// Says: The answer is right to seven digits only: somewhere it goes through float.
// Hint: Stay with double. Long steps and many bounces make the loss visible.
namespace single_precision {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const float gravity = float(g);
    float left = float(h), x = float(s.x), v = float(s.v);
    for (int bounces = 0; bounces < 2000; ++bounces) {
        const float impact = std::sqrt(v * v + 2 * gravity * x);
        const float fall = (v + impact) / gravity;
        if (fall > left)
            return {s.t + h, x + v * left - gravity * left * left / 2, v - gravity * left};
        left -= fall;
        x = 0;
        v = float(e) * impact;
    }
    return {s.t + h, 0, 0};
}

}  // namespace single_precision

// Says: After the landing the whole step begins anew. The fall has used up a part of it.
// Hint: How much time is left when the ball has landed? Only that much is for the bounces.
namespace whole_step_after_landing {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double impact = impact_of(s, g), fall = (s.v + impact) / g;
    return h < fall ? fly(s, g, h) : rest_of_step(s.t + h, g, e, h, e * impact);
}

}  // namespace whole_step_after_landing

// Says: Every step ends like that of the example.
// Hint: Begin with a ball that does not land: where is it after h?
namespace example {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return {1.5, 1.25, 0};
}

}  // namespace example

// Says: Where the ball comes to rest, the clock stops: the step ends at its last bounce.
// Hint: A ball at rest has time pass, too: the step ends at t + h, whatever happens in it.
namespace clock_stops_at_rest {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    double t = s.t, left = h;
    for (;;) {
        if (s.x == 0 && std::fabs(s.v) < 1e-9) return {t, 0, 0};
        const double impact = impact_of(s, g), fall = (s.v + impact) / g;
        if (fall > left) return {t + left, fly(s, g, left).x, s.v - g * left};
        left -= fall, t += fall;
        s = {t, 0, e * impact};
    }
}

}  // namespace clock_stops_at_rest

// Says: After the last bounce the ball flies for the whole step, and not only for what is left of it.
// Hint: You count down the time that is left. Which time belongs into the last flight?
namespace whole_step_at_last {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    double x = s.x, v = s.v, left = h;
    for (;;) {
        const double landing = std::sqrt(v * v + 2 * g * x), until = (v + landing) / g;
        if (landing == 0 || (e < 1 && landing < 1e-8)) return {s.t + h, 0.0, 0.0};
        if (left < until) break;
        left -= until;
        v = e * landing;
        x = 0;
    }
    return {s.t + h, x + v * h - g * h * h / 2, v - g * h};
}

}  // namespace whole_step_at_last

// Says: Height and velocity are right, but the time has gone on only by what was left after the last bounce.
// Hint: The state is that at the end of the step. Which time is that?
namespace time_of_the_rest {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    double x = s.x, v = s.v, left = h;
    for (;;) {
        const double landing = std::sqrt(v * v + 2 * g * x), until = (v + landing) / g;
        if (landing == 0 || (e < 1 && landing < 1e-8)) return {s.t + left, 0.0, 0.0};
        if (left < until) break;
        left -= until;
        v = e * landing;
        x = 0;
    }
    return {s.t + left, x + v * left - g * left * left / 2, v - g * left};
}

}  // namespace time_of_the_rest

// Says: The clock is that of the last landing: what is left of the step after it is not added.
// Hint: Whatever happened in the step, it ends at t + h.
namespace clock_of_the_last_landing {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    double up = s.x == 0 && s.v < 0 ? -e * s.v : s.v;
    while (s.x > 0 || up > 1e-9) {
        const double impact = std::sqrt(up * up + 2 * g * s.x), fall = (up + impact) / g;
        if (fall > h) return {s.t, s.x + up * h - g * h * h / 2, up - g * h};
        s = {s.t + fall, 0, 0};
        h -= fall, up = e * impact;
    }
    return {s.t, 0, 0};
}

}  // namespace clock_of_the_last_landing
