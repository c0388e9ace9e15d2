#include "exercise.hpp"

static State<double> fly(const State<double>& s, double g, double h) {
    return {s.t + h, s.x + s.v * h - g * h * h / 2, s.v - g * h};
}
static double impact_of(const State<double>& s, double g) {
    return std::sqrt(s.v * s.v + 2 * g * s.x);
}

// The course's answer, but for the velocity after a bounce and for when the ball is put to rest.
template <class Bounced, class Rests>
static State<double> all_bounces(State<double> s, double g, double h, Bounced bounced, Rests rests) {
    const double end = s.t + h;
    for (int bounces = 0; bounces < 5000; ++bounces) {
        const double impact = impact_of(s, g), fall = (s.v + impact) / g;
        if (fall > h) return {end, fly(s, g, h).x, s.v - g * h};
        h -= fall;
        s = {end, 0, bounced(impact, s.v)};
        if (rests(s.v, h)) break;
    }
    return {end, 0, 0};
}
// Are all bounces to come, each with e of the last one's speed, over in h?
static bool is_over(double v, double g, double e, double h) {
    return 2 * v / g <= (1 - e) * h;
}

// From the landing on, `left` before `end`: each bounce takes `times` v/g.
static State<double> rest_of_step(double end, double g, double e, double left, double up, double times = 2) {
    for (; up > 1e-8 && left > times * up / g; up *= e) left -= times * up / g;
    if (up <= 1e-8) return {end, 0, 0};
    return {end, up * left - g * left * left / 2, up - g * left};
}

// The course's answer up to the landing; from then on what is `left` of the step is `after(impact, fall)`.
template <class After>
static State<double> landed(const State<double>& s, double g, double h, After after) {
    const double impact = impact_of(s, g), fall = (s.v + impact) / g;
    if (s.x == 0 && s.v == 0) return {s.t + h, 0, 0};
    return fall > h ? fly(s, g, h) : after(impact, fall);
}

// Says: The ball is turned round at the end of the step, as in chapter 3: there it has sunk into the ground,
//       too fast and too late.
// Hint: When was it at height zero? Go back to that moment, and bounce there.
namespace after_the_step {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x == 0 && s.v == 0) return {s.t + h, 0, 0};
    const State<double> end = fly(s, g, h);
    return end.x < 0 ? State<double>{end.t, -e * end.x, -e * end.v} : end;
}

}  // namespace after_the_step

// Says: Between bounces your flight is semi-implicit Euler; it must be the exact parabola. And a bounce at
//       the end of the step comes too late.
// Hint: Gravity is constant: where is a thrown ball after h seconds, to the last digit? Do that first, and
//       then ask when it lands.
namespace semi_implicit_euler {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    s.v -= g * h;
    s.x += h * s.v;
    if (s.x < 0) s = {s.t, 0, -e * s.v};
    return {s.t + h, s.x, s.v};
}

}  // namespace semi_implicit_euler

// Says: Your flight is explicit Euler: for the whole step the ball keeps the velocity of its beginning.
//       Gravity bends its path meanwhile.
// Hint: With constant acceleration position and velocity after h are known exactly. Begin with these, then
//       the moment of the landing.
namespace explicit_euler {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    s.x += h * s.v;
    s.v -= g * h;
    if (s.x < 0) s = {s.t, 0, -e * s.v};
    return {s.t + h, s.x, s.v};
}

}  // namespace explicit_euler

// Says: The flight is right. But a ball that has sunk in is lifted to the ground at the end of the step and
//       turned round there: it should be on its way up for long.
// Hint: At which moment within the step was it at height zero, and how fast? For how long does it fly from
//       then on?
namespace lifted_after_the_step {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    s.x += s.v * h - g * h * h / 2;
    s.v -= g * h;
    if (s.x < 0) s = {s.t, 0, -e * s.v};
    return {s.t + h, s.x, s.v};
}

}  // namespace lifted_after_the_step

// Says: The first bounce is right. But the ball comes down again within a long step, and then falls through
//       the ground.
// Hint: After a bounce the same question comes again: does it land before the step is over?
namespace one_bounce {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return landed(s, g, h, [&](double impact, double fall) {
        return fly({s.t + fall, 0, e * impact}, g, h - fall);
    });
}

}  // namespace one_bounce

// Says: After the first bounce the ball stays on the ground as soon as it comes down again.
// Hint: A second bounce is no other than the first. A loop takes them all.
namespace waits_at_second {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return landed(s, g, h, [&](double impact, double fall) {
        if (2 * e * impact / g <= h - fall) return State<double>{s.t + h, 0, 0};
        return fly({s.t + fall, 0, e * impact}, g, h - fall);
    });
}

}  // namespace waits_at_second

// Says: After the bounce the ball rises in a straight line, at one speed, for the rest of the step: gravity
//       is forgotten.
// Hint: From the bounce on it is a throw like any other.
namespace straight_after_bounce {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return landed(s, g, h, [&](double impact, double fall) {
        return State<double>{s.t + h, e * impact * (h - fall), e * impact};
    });
}

}  // namespace straight_after_bounce

// Says: The bounce turns round the velocity that the ball would have at the end of the step, below the
//       ground. It is faster than the ball was at the impact.
// Hint: Which velocity has it at height zero?
namespace velocity_of_the_end {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return landed(s, g, h, [&](double, double fall) {
        return fly({s.t + fall, 0, e * (g * h - s.v)}, g, h - fall);
    });
}

}  // namespace velocity_of_the_end

// Says: The bounce turns round the velocity of the beginning of the step. Until the impact gravity has
//       changed it.
// Hint: How fast is the ball at height zero? Its energy tells.
namespace velocity_of_the_start {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    return all_bounces(s, g, h, [&](double, double before) { return e * std::fabs(before); },
                       [&](double v, double left) { return is_over(v, g, e, left); });
}

}  // namespace velocity_of_the_start

// Says: The moment of the impact is found on a straight line from the first height to the last. The path is
//       a parabola.
// Hint: Gravity is constant: the height is a quadratic in time, and its root is known.
namespace straight_to_the_ground {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x == 0 && s.v == 0) return {s.t + h, 0, 0};
    const State<double> end = fly(s, g, h);
    if (end.x >= 0) return end;
    const double fall = h * s.x / (s.x - end.x);
    return fly({s.t + fall, 0, -e * (s.v - g * fall)}, g, h - fall);
}

}  // namespace straight_to_the_ground

// Says: The ball lands when, and as fast as, one that is let go at rest: the velocity at the beginning is not in it.
// Hint: Solve s.x + s.v t - g t^2 / 2 = 0 for t, with the middle term.
namespace thrown_as_dropped {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double impact = std::sqrt(2 * g * s.x), fall = impact / g;
    return h < fall ? fly(s, g, h) : rest_of_step(s.t + h, g, e, h - fall, e * impact);
}

}  // namespace thrown_as_dropped

// Says: The speed of the impact is right, but not its moment: it is that of a ball that is let go at rest.
// Hint: On its way gravity changes the velocity by g a second, from that of the beginning to that of the impact.
namespace moment_of_a_drop {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double fall = std::sqrt(2 * s.x / g);
    return h < fall ? fly(s, g, h) : rest_of_step(s.t + h, g, e, h - fall, e * impact_of(s, g));
}

}  // namespace moment_of_a_drop

// Says: In the height g t^2 has lost its one half.
// Hint: Constant acceleration moves a body by half of it times t^2.
namespace half_forgotten {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    double left = h;
    for (int bounces = 0; bounces < 5000; ++bounces) {
        const double impact = std::sqrt(s.v * s.v + 2 * g * s.x);
        const double fall = (s.v + impact) / g;
        if (fall > left) return {end, s.x + s.v * left - g * left * left, s.v - g * left};
        left -= fall;
        s.x = 0;
        s.v = e * impact;
        if (2 * s.v / g <= (1 - e) * left) return {end, 0, 0};
    }
    return {end, 0, 0};
}

}  // namespace half_forgotten

// Says: Gravity pulls up in your flight.
// Hint: g is given above zero, and upwards is above zero, too. Which sign must it have?
namespace falls_up {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x == 0 && s.v == 0) return {s.t + h, 0, 0};
    return fly(s, -g, h);
}

}  // namespace falls_up

// Says: The ball stops where it lands: it does not bounce at all.
// Hint: It leaves the ground with e times the speed that it came with.
namespace stops_where_it_lands {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double fall = (s.v + impact_of(s, g)) / g;
    return h < fall ? fly(s, g, h) : State<double>{s.t + h, 0, 0};
}

}  // namespace stops_where_it_lands

// Says: In the time of the fall the velocity has the wrong sign: a ball that was thrown up lands sooner.
// Hint: A ball that rises first takes longer. Check the root that you chose with a throw from the ground.
namespace fall_with_wrong_sign {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double impact = impact_of(s, g), fall = (impact - s.v) / g;
    return h < fall ? fly(s, g, h) : rest_of_step(s.t + h, g, e, h - fall, e * impact);
}

}  // namespace fall_with_wrong_sign

// Says: The half before g t^2 is missing everywhere: in the height, in the time until the ball lands, and in the
//       time of a bounce.
// Hint: The mean velocity of a fall from rest is half of the last one. So how far is it after t?
namespace half_forgotten_everywhere {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double fall = (s.v + std::sqrt(s.v * s.v + 4 * g * s.x)) / (2 * g);
    if (h < fall) return {s.t + h, s.x + s.v * h - g * h * h, s.v - g * h};
    double left = h - fall, up = e * std::fabs(s.v - g * fall);
    for (int bounces = 0; bounces < 2000 && up > 1e-8 && left > up / g; ++bounces, up *= e) left -= up / g;
    if (up <= 1e-8 || left > up / g) return {s.t + h, 0, 0};
    return {s.t + h, up * left - g * left * left, up - g * left};
}

}  // namespace half_forgotten_everywhere

// Says: The landing speed is that of a ball let go at this height: the velocity that it had is forgotten.
// Hint: A ball thrown down lands faster than one that is let go. Add both energies.
namespace height_alone {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    double x = s.x, v = s.v, left = h;
    for (;;) {
        const double landing = std::sqrt(v * v + 2 * g * x), until = (v + landing) / g;
        if (landing == 0 || (e < 1 && landing < 1e-8)) return {s.t + h, 0.0, 0.0};
        if (left < until) break;
        left -= until;
        v = x > 0 ? e * std::sqrt(2 * g * x) : e * std::fabs(v);
        x = 0;
    }
    return {s.t + h, x + v * left - g * left * left / 2, v - g * left};
}

}  // namespace height_alone

// Says: The landings are right, but the last flight is a step of semi-implicit Euler: the half before g t^2 is
//       missing in its height.
// Hint: Until it lands the ball is on a parabola, and so it is at the end of the step. Where is it after the
//       time that is left?
namespace last_flight_semi_implicit {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    const double end = s.t + h;
    if (s.x == 0 && s.v < 0) s.v *= -e;
    for (; s.x > 0 || s.v > 1e-9;) {
        const double impact = impact_of(s, g), fall = (s.v + impact) / g;
        if (fall > h) return {end, std::max(0.0, s.x + h * (s.v - g * h)), s.v - g * h};
        h -= fall;
        s = {end, 0, e * impact};
    }
    return {end, 0, 0};
}

}  // namespace last_flight_semi_implicit

// Says: The landing is that of a ball that is let go at rest from this height, its moment and its speed: the
//       velocity that it had is forgotten.
// Hint: A ball that is thrown down lands sooner and faster. Put v into the height and into the energy.
namespace falls_from_rest {

State<double> land_and_bounce(State<double> s, double g, double e, double h) {
    if (s.x == 0) return s.v < 0 ? rest_of_step(s.t + h, g, e, h, -e * s.v) : rest_of_step(s.t + h, g, e, h, s.v);
    const double fall = std::sqrt(2 * s.x / g);
    return fall > h ? fly(s, g, h) : rest_of_step(s.t + h, g, e, h - fall, e * g * fall);
}

}  // namespace falls_from_rest
