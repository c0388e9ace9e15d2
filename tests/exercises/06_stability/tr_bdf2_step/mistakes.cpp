#include "exercise.hpp"

// Position and velocity.
using Pair = std::array<double, 2>;

static Pair plus(const Pair& a, double share, const Pair& b) {
    return {a[0] + share * b[0], a[1] + share * b[1]};
}

// The turret, and its step in two parts as it should be.
struct Turret {
    double omega, zeta, gamma = 2 - std::sqrt(2.0);

    Pair rate(const Pair& y) const { return {y[1], -omega * omega * y[0] - 2 * zeta * omega * y[1]}; }
    // The y with y - part f(y) = known.
    Pair solve(double part, const Pair& known) const {
        const double wa = omega * part;
        const double v2 = (known[1] - wa * omega * known[0]) / (1 + 2 * zeta * wa + wa * wa);
        return {known[0] + part * v2, v2};
    }
    Pair trapezoid(double h, const Pair& y1) const { return solve(h / 2, plus(y1, h / 2, rate(y1))); }
    Pair middle(double h, const Pair& y1) const { return trapezoid(gamma * h, y1); }
    // y1, and w times as far as to ym: what the parabola makes of the two.
    Pair between(const Pair& y1, const Pair& ym, double w) const { return plus(y1, w, plus(ym, -1, y1)); }
    double weight() const { return 1 / (gamma * (2 - gamma)); }
    double end_part(double h) const { return (1 - gamma) / (2 - gamma) * h; }
    Pair end(double h, const Pair& y1, const Pair& ym) const { return solve(end_part(h), between(y1, ym, weight())); }
    Pair step(double h, const Pair& y1) const { return end(h, y1, middle(h, y1)); }
    Pair by(double h, const Pair& y1, double part, double w) const { return solve(part, between(y1, middle(h, y1), w)); }
};

static State<double> at(double t, const Pair& y) {
    return {t, y[0], y[1]};
}

// Says: This is the trapezoid rule for the whole step, or implicit midpoint, which is the same here: it rings.
// Hint: Only a part of gamma h goes by the trapezoid rule. Then comes the parabola.
namespace trapezoid_only {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta}.trapezoid(h, {s.x, s.v}));
}

}  // namespace trapezoid_only

// Says: This is implicit Euler: it does not ring, but it has order one.
// Hint: Two parts: first the state between, by the trapezoid rule.
namespace implicit_euler {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta}.solve(h, {s.x, s.v}));
}

}  // namespace implicit_euler

// Says: The first part is a step of implicit Euler: order two is lost.
// Hint: The trapezoid rule takes the mean of the rates at both of its ends. One of them, f(y1), is known.
namespace first_by_implicit_euler {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.end(h, {s.x, s.v}, turret.solve(turret.gamma * h, {s.x, s.v})));
}

}  // namespace first_by_implicit_euler

// Says: The first part is a step of explicit Euler. With a stiff spring the state between is far out, and the parabola
//       cannot mend that.
// Hint: ym stands on both sides of the first line. Solve for it.
namespace first_explicit {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v};
    return at(s.t + h, turret.end(h, y1, plus(y1, turret.gamma * h, turret.rate(y1))));
}

}  // namespace first_explicit

// Says: The rest of the step is implicit Euler from the state between: order two is lost.
// Hint: The parabola goes through three states. Where does y1 come in again?
namespace end_by_implicit_euler {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.solve((1 - turret.gamma) * h, turret.middle(h, {s.x, s.v})));
}

}  // namespace end_by_implicit_euler

// Says: The weights are those of BDF2 with even steps, where the state between lies half way. Here it lies at gamma h.
// Hint: Work out the slope of the parabola through 0, gamma h and h anew. With gamma = 1/2 the weights of BDF2 must
//       come out.
namespace even_weights {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta}.by(h, {s.x, s.v}, h / 3, 4.0 / 3));
}

}  // namespace even_weights

// Says: The state between lies half way: gamma is 1/2. A sound method, but not the one asked for.
// Hint: gamma = 2 - sqrt(2), which is about 0.586. Then both parts have the same divisor.
namespace half_way {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta, 0.5}.step(h, {s.x, s.v}));
}

}  // namespace half_way

// Says: gamma is half of what it should be. 1 - 1/sqrt(2) belongs to another method, or to gamma / 2.
// Hint: gamma = 2 - sqrt(2).
namespace gamma_of_another {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta, 1 - 1 / std::sqrt(2.0)}.step(h, {s.x, s.v}));
}

}  // namespace gamma_of_another

// Says: Right to some digits only: gamma, or a weight, is rounded.
// Hint: Let std::sqrt compute it.
namespace rounded_gamma {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta, 0.5858}.step(h, {s.x, s.v}));
}

}  // namespace rounded_gamma

// Says: y1 and ym have each other's weight.
// Hint: The parabola leans on the nearer state: it has a weight above one, and the old one a small negative weight.
namespace weights_swapped {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.by(h, {s.x, s.v}, turret.end_part(h), 1 - turret.weight()));
}

}  // namespace weights_swapped

// Says: The rate of the second part is taken at the state between, so the end is not implicit: stiff springs blow up.
// Hint: The slope at the end is f(y2). Solve for y2, with the same function as for ym.
namespace slope_at_middle {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v}, ym = turret.middle(h, y1);
    return at(s.t + h, plus(turret.between(y1, ym, turret.weight()), turret.end_part(h), turret.rate(ym)));
}

}  // namespace slope_at_middle

// Says: The second part is a trapezoid rule as well. Two of them in a row ring like one.
// Hint: The second part looks at no old rate: three states and the rate at the end are all.
namespace slope_of_second_chord {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.trapezoid((1 - turret.gamma) * h, turret.middle(h, {s.x, s.v})));
}

}  // namespace slope_of_second_chord

// Says: You return the state between, with the time of the end.
// Hint: The parabola is missing, or its result is not used.
namespace middle_returned {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta}.middle(h, {s.x, s.v}));
}

}  // namespace middle_returned

// Says: The state is right, but its time is that of the state between.
// Hint: A whole step has gone by.
namespace clock_of_middle {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + turret.gamma * h, turret.step(h, {s.x, s.v}));
}

}  // namespace clock_of_middle

// Says: The velocity is right, but the position moves with it as in semi-implicit Euler.
// Hint: Position and velocity go through the same two parts. The second number of your solve is v2, the first x2.
namespace position_after_velocity {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const double v2 = Turret{omega, zeta}.step(h, {s.x, s.v})[1];
    return {s.t + h, s.x + h * v2, v2};
}

}  // namespace position_after_velocity

// Says: The damper is half as strong as zeta says: it has lost its factor two.
// Hint: Compare with f(y) in the task, in the rate and in the divisor.
namespace half_damping {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta / 2}.step(h, {s.x, s.v}));
}

}  // namespace half_damping

// Says: zeta has no influence.
// Hint: The rate of v has two terms, and so has the divisor of each solve.
namespace no_damping {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, 0}.step(h, {s.x, s.v}));
}

}  // namespace no_damping

// Says: Right to seven or eight digits, and no more.
// Hint: Use double for everything, and let std::sqrt find the root of two.
namespace single_precision {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta}.step(h, {static_cast<float>(s.x), static_cast<float>(s.v)}));
}

}  // namespace single_precision

// Says: The weights are those of BDF2 with even steps, and its two thirds stand before all of h, not before half of it.
// Hint: Here the state between lies at gamma h. Work out the slope of the parabola at its end, in terms of h.
namespace even_weights_of_h {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return at(s.t + h, Turret{omega, zeta}.by(h, {s.x, s.v}, 2 * h / 3, 4.0 / 3));
}

}  // namespace even_weights_of_h

// Says: The first part has lost its half: each of its two rates acts for all of gamma h.
// Hint: The trapezoid rule takes the mean of the two rates. Compare with gamma h/2 in the task.
namespace half_forgotten {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v};
    return at(s.t + h, turret.end(h, y1, turret.trapezoid(2 * turret.gamma * h, y1)));
}

}  // namespace half_forgotten

// Says: y1 has the wrong sign in the second part: its weight there is negative.
// Hint: The weights of y1 and ym add up to one. With a body at rest away from zero, and no spring, does it stay?
namespace old_weight_positive {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v}, ym = turret.middle(h, y1);
    const double w = turret.weight();
    return at(s.t + h, turret.solve(turret.end_part(h), {w * ym[0] + (w - 1) * s.x, w * ym[1] + (w - 1) * s.v}));
}

}  // namespace old_weight_positive

// Says: The clock has been moved on twice: by gamma h in the first part, and by h at the end.
// Hint: Both parts together last h. The second begins at gamma h, and ends at h.
namespace clock_of_both {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + turret.gamma * h + h, turret.step(h, {s.x, s.v}));
}

}  // namespace clock_of_both

// Says: The spring pulls with omega x, where omega² x belongs.
// Hint: Look at f(y) in the task, and at its units: an acceleration is metres over seconds squared.
namespace omega_without_square {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const double root = std::sqrt(omega);  // its square is pulled with; the damper is as it should be
    return at(s.t + h, Turret{root, zeta * root}.step(h, {s.x, s.v}));
}

}  // namespace omega_without_square

// Says: The velocity goes through both parts, but the position is that of the state between.
// Hint: In each part x and v are solved for together. Which x belongs to v2?
namespace position_left {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v}, ym = turret.middle(h, y1);
    return {s.t + h, ym[0], turret.end(h, y1, ym)[1]};
}

}  // namespace position_left

// Says: Every turret gets the state of the example.
// Hint: Begin with one solve: y - part f(y) = something known.
namespace example {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    return {0.1, 0.63761, -6.6344};
}

}  // namespace example

// Says: The first part has lost f(y1): it is implicit Euler over half of gamma h.
// Hint: The trapezoid rule takes the mean of both rates: that at y1 comes to the right side.
namespace first_part_without_old_rate {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v};
    return at(s.t + h, turret.end(h, y1, turret.solve(turret.gamma * h / 2, y1)));
}

}  // namespace first_part_without_old_rate

// Says: The second part goes on for (1 - gamma) h, as if it were implicit Euler: the divisor 2 - gamma is missing.
// Hint: What stands before h f(y2), once y2 stands alone, is (1 - gamma)/(2 - gamma).
namespace end_for_all_of_the_rest {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.by(h, {s.x, s.v}, (1 - turret.gamma) * h, turret.weight()));
}

}  // namespace end_for_all_of_the_rest

// Says: The weights are those of BDF2 with even steps, 4/3, -1/3, and 2/3 of the rest of h: but these steps are uneven.
// Hint: The state between lies at gamma h. Work out the slope of the parabola anew: gamma = 1/2 must give your weights.
namespace even_weights_of_the_rest {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.by(h, {s.x, s.v}, 2 * (1 - turret.gamma) * h / 3, 4.0 / 3));
}

}  // namespace even_weights_of_the_rest

// Says: In the weight of y1, 1 - gamma has lost its square.
// Hint: Without a spring the turret moves on by h v. Work out both weights from that, and from their sum, which is one.
namespace square_forgotten {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    return at(s.t + h, turret.by(h, {s.x, s.v}, turret.end_part(h), 1 + (1 - turret.gamma) * turret.weight()));
}

}  // namespace square_forgotten
