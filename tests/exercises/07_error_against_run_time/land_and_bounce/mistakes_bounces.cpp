// What a bounce keeps, how many there are, and when the ball lies still.

// Says: The restitution is taken as the share of the energy that is kept. It is the share of the speed.
// Hint: Multiply the speed by e. What happens to the energy then?
namespace energy_share {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return std::sqrt(e) * impact; },
                       [&](double v, double left) { return is_over(v, g, std::sqrt(e), left); });
}

}  // namespace energy_share

// Says: The speed after a bounce is e^2 of the speed before, where it has one e. Is that the share of the energy, or
//       does e come in twice?
// Hint: The height it comes back to is e^2 of what it was. What do you get for a ball that is dropped?
namespace e_squared {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return e * e * impact; },
                       [&](double v, double left) { return is_over(v, g, e * e, left); });
}

}  // namespace e_squared

// Says: Every bounce is one that loses nothing: e is not used.
// Hint: With which speed does the ball leave the ground?
namespace loses_nothing {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return impact; },
                       [&](double v, double left) { return v == 0; });
}

}  // namespace loses_nothing

// Says: After a certain number of bounces in a step the ball is left lying, even if it would still jump.
// Hint: A bound on the number is wise, but it must let all through that the task allows. When does a ball with this
//       e really lie still?
namespace ten_bounces {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    int bounces = 0;
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double, double) { return ++bounces > 10; });
}

}  // namespace ten_bounces

// Says: After many bounces you give up, and let the ball fall for what is left of the step: through the
//       ground.
// Hint: A ball that bounces without end in a finite time lies still after it.
namespace falls_at_last {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    int bounces = 0;
    State<double> last{s.t + h, 0, 0};
    const State<double> end = all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                                          [&](double v, double left) {
                                              last = fly({s.t + h - left, 0, v}, g, left);
                                              return ++bounces > 1500;
                                          });
    return bounces > 1500 ? last : end;
}

}  // namespace falls_at_last

// Says: Slow bounces are left out, as some engines do to calm their piles. Here they count.
// Hint: You see a ball of 0.5 m/s rise by a centimetre. The sum of a series says when it is over.
namespace slow_bounces_left_out {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double v, double left) { return v < 1 || is_over(v, g, e, left); });
}

}  // namespace slow_bounces_left_out

// Says: Bounces of less than a tenth of a millimetre per second are left out. Only those below a millionth of a metre
//       per second need not be right.
// Hint: Let the time decide, and no speed: the sum of all bounces to come is known.
namespace slowest_bounces_left_out {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double v, double left) { return v < 1e-4 || is_over(v, g, e, left); });
}

}  // namespace slowest_bounces_left_out

// Says: The ball is put to rest when half of the time of its bounces would still be to come: a bounce takes
//       as long up as down.
// Hint: How long does a throw with speed v take until it is down again?
namespace rests_too_early {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double v, double left) { return is_over(v / 2, g, e, left); });
}

}  // namespace rests_too_early

// Says: The next bounce is left out of your sum: a ball whose later bounces fit into the rest of the step is
//       put to rest, though the next one is not over.
// Hint: The series begins with 1, the bounce that has just begun.
namespace rests_a_bounce_early {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double v, double left) { return is_over(v * e, g, e, left); });
}

}  // namespace rests_a_bounce_early

// Says: A ball that begins the step on the ground, at rest or moving down, falls through it.
// Hint: It is at the impact already: the time until then is zero. Does your comparison leave that out?
namespace sinks {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x <= 0 && s.v <= 0) return fly(s, g, h);
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double v, double left) { return is_over(v, g, e, left); });
}

}  // namespace sinks

// Says: Only the first bounce loses speed. All later ones throw the ball as high as the first.
// Hint: Each bounce multiplies the speed by e once more.
namespace later_bounces_lose_nothing {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double impact = impact_of(s, g), fall = (s.v + impact) / g, up = e * impact;
    if (h < fall) return fly(s, g, h);
    if (up == 0) return {s.t + h, 0, 0};
    const double left = std::fmod(h - fall, 2 * up / g);
    return {s.t + h, up * left - g * left * left / 2, up - g * left};
}

}  // namespace later_bounces_lose_nothing

// Says: A bounce takes the time to its top. The ball also comes down again.
// Hint: It lands as fast as it left. By how much has its velocity changed, at g a second?
namespace way_up_only {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double impact = impact_of(s, g), fall = (s.v + impact) / g;
    return h < fall ? fly(s, g, h) : rest_of_step(s.t + h, g, e, h - fall, e * impact, 1);
}

}  // namespace way_up_only

// Says: A ball that begins the step on the ground and moves down is put to rest. It bounces at once.
// Hint: Only a ball with velocity 0 lies on the ground. One that moves down has just come.
namespace down_on_the_ground_rests {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x <= 0 && s.v <= 0) return {s.t + h, 0, 0};
    return all_bounces(s, g, h, [&](double impact, double) { return e * impact; },
                       [&](double v, double left) { return is_over(v, g, e, left); });
}

}  // namespace down_on_the_ground_rests

// Says: Whatever begins the step on the ground is taken to lie there. It may be on its way up, or come down.
// Hint: At height zero there are three cases: v above zero, below zero, and zero.
namespace ground_is_rest {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    if (s.x == 0) return {end, 0, 0};
    return landed(s, g, h, [&](double impact, double fall) { return rest_of_step(end, g, e, h - fall, e * impact); });
}

}  // namespace ground_is_rest
