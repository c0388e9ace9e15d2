// What the two parts are, and how each is solved.

// Says: The first part goes over the whole step. The trapezoid rule is to go as far as gamma h, and the
//       parabola from there.
// Hint: Which state is to lie between the two others, and when?
namespace trapezoid_too_long {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v};
    return at(s.t + h, turret.end(h, y1, turret.trapezoid(h, y1)));
}

}  // namespace trapezoid_too_long

// Says: In each part the new velocity takes the spring at the place before it, and only the damper anew. Place
//       and velocity hang on each other, and must be solved for together.
// Hint: Put x = X + part v into the line of the velocity. Then one unknown is left, with the square of omega
//       part beside it.
namespace not_solved_together {

State<double> tr_bdf2_step(State<double> s, double omega, double zeta, double h) {
    const Turret turret{omega, zeta};
    const Pair y1{s.x, s.v};
    const double part = turret.gamma * h / 2, damped = 1 + 2 * zeta * omega * part, k = omega * omega;
    const double vm = (s.v + part * (turret.rate(y1)[1] - k * s.x)) / damped;
    const Pair known = turret.between(y1, {s.x + part * (s.v + vm), vm}, turret.weight());
    const double v2 = (known[1] - part * k * (s.x + part * (s.v + vm))) / damped;
    return at(s.t + h, {known[0] + part * v2, v2});
}

}  // namespace not_solved_together
