#include "exercise.hpp"

// Says: A division of whole numbers: p * q / (q - p) is cut to a whole number, or there is a 1 / p, which is zero
//       but for order one.
// Hint: Write 1.0 for one of the numbers.
namespace whole_number_division {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(a_of_1 / b_of_1, p * q / (q - p));
    return {a_of_1 / std::pow(error, 1.0 / p), error};
}

}  // namespace whole_number_division

// Says: 1 / (q - p) is a division of whole numbers: one for neighbouring orders, which is right, and zero
//       for all others.
// Hint: Two int make an int. One of them must be a double, as in 1.0 / n.
namespace whole_number_root {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // After S seconds the error is a_at_1 / S^p, and b_at_1 / S^q.
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = std::pow(b_at_1 / a_at_1, 1 / (q - p));
    return {seconds, a_at_1 / std::pow(seconds, p)};
}

}  // namespace whole_number_root

// Says: You have S^(q - p), and raise it to the power q - p once more. To get S, that power must be undone.
// Hint: If S^3 is 8, what is S? By which power of 8 do you get it?
namespace power_for_root {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // After S seconds the error is a_at_1 / S^p, and b_at_1 / S^q.
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = std::pow(b_at_1 / a_at_1, q - p);
    return {seconds, a_at_1 / std::pow(seconds, p)};
}

}  // namespace power_for_root

// Says: You return S^(q - p) for the seconds. That is S only where the orders are neighbours.
// Hint: One thing is left to do: a root. Which?
namespace no_root {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // After S seconds the error is a_at_1 / S^p, and b_at_1 / S^q.
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = b_at_1 / a_at_1;
    return {seconds, a_at_1 / std::pow(seconds, p)};
}

}  // namespace no_root

// Says: Your lines rise: the error grows with the run time as it grows with the step. But more time means
//       shorter steps.
// Hint: Twice the time is half the step. So the time stands in the denominator.
namespace lines_rise {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x = (std::log(b[1] / a[1]) + p * std::log(a[0]) - q * std::log(b[0])) / (p - q);
    return {std::exp(x), a[1] * std::pow(std::exp(x) / a[0], p)};
}

}  // namespace lines_rise

// Says: The seconds fall with the error to the power of the order, where its root is needed: the slopes are
//       upside down.
// Hint: Twice the steps have an error 2^p times smaller. So how many times more steps has half the error?
namespace order_for_root {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], p), b_of_1 = b[0] * std::pow(b[1], q);
    const double error = std::pow(b_of_1 / a_of_1, 1.0 / (q - p));
    return {a_of_1 / std::pow(error, p), error};
}

}  // namespace order_for_root

// Says: The orders have changed places: A's line is q steep, and B's p.
// Hint: Which of the four arguments belong together?
namespace orders_swapped {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / q), b_of_1 = b[0] * std::pow(b[1], 1.0 / p);
    const double error = std::pow(a_of_1 / b_of_1, 1 / (1.0 / q - 1.0 / p));
    return {a_of_1 / std::pow(error, 1.0 / q), error};
}

}  // namespace orders_swapped

// Says: The root of the quotient is taken with q - p alone. That is the exponent for two errors of one step;
//       here E stands under two roots.
// Hint: E^(1/p) over E^(1/q) is E to which power?
namespace exponent_of_difference {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(a_of_1 / b_of_1, 1.0 / (q - p));
    return {a_of_1 / std::pow(error, 1.0 / p), error};
}

}  // namespace exponent_of_difference

// Says: The error is one over what it should be: somewhere a quotient or the sign of an exponent is upside
//       down.
// Hint: If A gets slower the crossing moves to larger errors. Does yours?
namespace upside_down {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(b_of_1 / a_of_1, 1 / (1.0 / p - 1.0 / q));
    return {a_of_1 / std::pow(error, 1.0 / p), error};
}

}  // namespace upside_down

// Says: The seconds are one over what they should be: in the equation for S a quotient or a sign is upside
//       down.
// Hint: Let B's steps cost more: the crossing moves to longer runs. Does yours?
namespace seconds_upside_down {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    // After S seconds the error is a_at_1 / S^p, and b_at_1 / S^q.
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = std::pow(a_at_1 / b_at_1, 1.0 / (q - p));
    return {seconds, a_at_1 / std::pow(seconds, p)};
}

}  // namespace seconds_upside_down

// Says: Only the errors are compared: the time that the two runs took does not matter to you. It is half of
//       the diagram.
// Hint: What if B's step cost ten times as much? B's point would move to the right.
namespace seconds_left_out {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double root_a = std::pow(a[1], 1.0 / p), root_b = std::pow(b[1], 1.0 / q);
    const double error = std::pow(root_a / root_b, 1 / (1.0 / p - 1.0 / q));
    return {a[0] * root_a / std::pow(error, 1.0 / p), error};
}

}  // namespace seconds_left_out

// Says: The error is right, but the seconds are those of A's run, not those at the crossing.
// Hint: How much longer must A run to get from its error to that of the crossing?
namespace seconds_of_a {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    return {a[0], std::pow(a_of_1 / b_of_1, 1 / (1.0 / p - 1.0 / q))};
}

}  // namespace seconds_of_a

// Says: The two numbers have changed places: first come the seconds, then the error.
// Hint: Write them in the order that the runs have, too.
namespace swapped {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(a_of_1 / b_of_1, 1 / (1.0 / p - 1.0 / q));
    return {error, a_of_1 / std::pow(error, 1.0 / p)};
}

}  // namespace swapped

// Says: Both orders are one too high: that is the error of one step. A run adds up many.
// Hint: The error of a run is C h^order. No power more.
namespace one_order_more {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    ++p;
    ++q;
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(a_of_1 / b_of_1, 1 / (1.0 / p - 1.0 / q));
    return {a_of_1 / std::pow(error, 1.0 / p), error};
}

}  // namespace one_order_more

// Says: This is the middle between the two points on the diagram. The lines cross there only by chance:
//       where do the orders come in?
// Hint: Follow each line from its point, p or q decades down for a decade to the right.
namespace half_way {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    return {std::sqrt(a[0] * b[0]), std::sqrt(a[1] * b[1])};
}

}  // namespace half_way

// Says: Your lines are straight on plain paper: the error falls by p for each second. It is the logarithms
//       that lie on a line.
// Hint: Take the logarithm of all four numbers first, work with these, and undo it at the end with std::exp.
namespace no_logarithms {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double seconds = (b[1] - a[1] + q * b[0] - p * a[0]) / (q - p);
    return {seconds, a[1] - p * (seconds - a[0])};
}

}  // namespace no_logarithms

// Says: Your lines begin with the error of the run, as if every run had taken one second. Each must go
//       through its point, with its seconds, too.
// Hint: log E = c - p log S. Put the point of A in. What is c?
namespace intercept_left_out {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x = (std::log(b[1]) - std::log(a[1])) / (q - p);
    return {std::exp(x), std::exp(std::log(a[1]) - p * x)};
}

}  // namespace intercept_left_out

// Says: The seconds are right. For the error you take S^-p: the slope alone, without where the line begins.
// Hint: A's line goes through A's point. How far is it from there to the crossing, in log S? So how far
//       down?
namespace slope_alone {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x_a = std::log(a[0]), y_a = std::log(a[1]);
    const double x_b = std::log(b[0]), y_b = std::log(b[1]);
    const double x = (y_b - y_a + q * x_b - p * x_a) / (q - p);
    return {std::exp(x), std::exp(-p * x)};
}

}  // namespace slope_alone

// Says: The seconds are right. But then your error grows with them along A's line, and it must fall: longer
//       runs have shorter steps.
// Hint: Twice the seconds are 2^p times less error. Look at the last sign, or at what stands over what.
namespace rises_at_last {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x_a = std::log(a[0]), y_a = std::log(a[1]);
    const double x_b = std::log(b[0]), y_b = std::log(b[1]);
    const double x = (y_b - y_a + q * x_b - p * x_a) / (q - p);
    return {std::exp(x), std::exp(y_a + p * (x - x_a))};
}

}  // namespace rises_at_last

// Says: The logarithms are to the base ten, but are undone with exp, which belongs to base e.
// Hint: std::log goes with std::exp. For std::log10 use std::pow(10, ...).
namespace logarithms_mixed {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double x_a = std::log10(a[0]), y_a = std::log10(a[1]);
    const double x_b = std::log10(b[0]), y_b = std::log10(b[1]);
    const double x = (y_b - y_a + q * x_b - p * x_a) / (q - p);
    return {std::exp(x), std::exp(y_a - p * (x - x_a))};
}

}  // namespace logarithms_mixed

// Says: The answer is right to a few digits only: somewhere it goes through float, and a twelfth power makes
//       more of its roundoff.
// Hint: Stay with double, in logarithms as well.
namespace single_precision {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const float x_a = float(std::log(a[0])), y_a = float(std::log(a[1]));
    const float x_b = float(std::log(b[0])), y_b = float(std::log(b[1]));
    const double x = (y_b - y_a + q * x_b - p * x_a) / (q - p);
    return {std::exp(x), std::exp(y_a - p * (x - x_a))};
}

}  // namespace single_precision

// Says: The seconds are right. But then the error falls from A's point with the order of B.
// Hint: Through A's point goes A's line. How steep is that?
namespace other_slope_at_last {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = std::pow(b_at_1 / a_at_1, 1.0 / (q - p));
    return {seconds, a[1] * std::pow(a[0] / seconds, q)};
}

}  // namespace other_slope_at_last

// Says: How long A's run took is left out, as if it had been one second.
// Hint: After S seconds A's error is c / S^p. Its measured run tells c, by both of its numbers.
namespace a_took_one_second {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double seconds = std::pow(b[1] * std::pow(b[0], q) / a[1], 1.0 / (q - p));
    return {seconds, a[1] / std::pow(seconds, p)};
}

}  // namespace a_took_one_second

// Says: How long B's run took is left out, as if it had been one second.
// Hint: Let B's computer be twice as slow. Your lines would cross where they did.
namespace b_took_one_second {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_at_1 = a[1] * std::pow(a[0], p);
    const double seconds = std::pow(b[1] / a_at_1, 1.0 / (q - p));
    return {seconds, a_at_1 / std::pow(seconds, p)};
}

}  // namespace b_took_one_second

// Says: You divide by the sum of the orders. Both lines fall, so their slopes must be subtracted.
// Hint: Put the two lines equal, and bring both terms with log S to one side. A sign changes.
namespace sum_of_orders {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double a_at_1 = a[1] * std::pow(a[0], p), b_at_1 = b[1] * std::pow(b[0], q);
    const double seconds = std::pow(b_at_1 / a_at_1, 1.0 / (q + p));
    return {seconds, a_at_1 / std::pow(seconds, p)};
}

}  // namespace sum_of_orders

// Says: Whatever was measured, the lines cross where they do in the example.
// Hint: Begin with the seconds that A needs for any error.
namespace example {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    return {4, 0.01};
}

}  // namespace example

// Says: The two runs have each other's seconds.
// Hint: Each line goes through the seconds and the error of one and the same run.
namespace seconds_exchanged {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    std::swap(a[0], b[0]);
    const double a_of_1 = a[0] * std::pow(a[1], 1.0 / p), b_of_1 = b[0] * std::pow(b[1], 1.0 / q);
    const double error = std::pow(a_of_1 / b_of_1, 1 / (1.0 / p - 1.0 / q));
    return {a_of_1 / std::pow(error, 1.0 / p), error};
}

}  // namespace seconds_exchanged

// Says: Where B's line lies is reckoned with the order of A, and how steep it is with its own.
// Hint: The error of the run of B falls with its own order: four times the time, and what becomes of it?
namespace one_order_for_both {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double seconds = std::pow(b[1] / a[1] * std::pow(b[0] / a[0], p), 1.0 / (q - p));
    return {seconds, a[1] * std::pow(a[0] / seconds, p)};
}

}  // namespace one_order_for_both
