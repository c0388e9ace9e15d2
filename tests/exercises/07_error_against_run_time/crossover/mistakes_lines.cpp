// How the two lines are drawn, and where they meet.

// Says: The quotient of the two times enters once, where it should enter as often as the order says.
// Hint: Twice the time is half the step: by how much does the error of a method of order three fall?
namespace time_without_power {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double share = std::pow(b[0] * b[1] / (a[0] * a[1]), 1.0 / (q - p));
    return {a[0] * share, a[1] * std::pow(share, -p)};
}

}  // namespace time_without_power

// Says: The last root is missing: what you found is the quotient of the times to the power of q − p.
// Hint: Where the lines cross, T to the q − p is something known. And T itself?
namespace root_forgotten {

std::array<double, 2> crossover(std::array<double, 2> a, int p, std::array<double, 2> b, int q) {
    const double share = b[1] / a[1] * std::pow(b[0] / a[0], q);
    return {a[0] * share, a[1] * std::pow(share, -p)};
}

}  // namespace root_forgotten
