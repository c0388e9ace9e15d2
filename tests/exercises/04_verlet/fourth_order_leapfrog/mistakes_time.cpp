// The time, where angle and rate are right or tell it.

// Says: Angle and rate are right, but the time has gone on by one part only, p h.
// Hint: The three parts together are one step: what is the time at its end?
namespace time_of_last_part {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t + p * h, s.x, s.v};
}

}  // namespace time_of_last_part

// Says: Angle and rate are right, but the time is still that of the beginning.
// Hint: A state has a time as well. How much later is it after a step?
namespace time_forgotten {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
    }
    return {s.t, s.x, s.v};
}

}  // namespace time_forgotten

// Says: p and q have changed places: two steps back and one forward do not go on by h, and the time tells it.
// Hint: Add up what your three steps go on by. It must be h.
namespace swapped_in_time {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {q * h, p * h, q * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.t += part;
    }
    return s;
}

}  // namespace swapped_in_time

// Says: The step in the middle has the right length but goes forward: the three together go on by more than
//       h, and the time tells it.
// Hint: 2p + q must be 1, and p alone is above 1.
namespace back_step_forward_in_time {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 2 * p - 1;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.t += part;
    }
    return s;
}

}  // namespace back_step_forward_in_time

// Says: Angle and rate are right, but the time has gone on by h in each of the three parts.
// Hint: The three together are one step of h. How far does the time go on in each?
namespace three_times_the_time {

State<double> fourth_order_leapfrog(State<double> s, double omega, double h) {
    const double p = 1 / (2 - std::cbrt(2.0)), q = 1 - 2 * p;
    for (const double part : {p * h, q * h, p * h}) {
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.x += part * s.v;
        s.v -= part / 2 * omega * omega * std::sin(s.x);
        s.t += h;
    }
    return s;
}

}  // namespace three_times_the_time
