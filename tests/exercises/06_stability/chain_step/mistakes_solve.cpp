// What is no solution of the equations together.

// Says: The masses are stepped one after the other, each with the new place of the one above and the old place
//       of the one below. All new velocities hang on one another: they must be solved for together.
// Hint: Write down the equations of two masses. Put the second into the first, as at school.
namespace sweep_past_a_still_one {

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    double above = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const bool is_last = i + 1 == s.size();
        const double links = is_last ? 1 : 2, pull = above + (is_last ? 0 : s[i + 1].x) - links * s[i].x;
        s[i].v = (m * s[i].v + h * k * pull) / (m + links * h * h * k);
        s[i].t += h, s[i].x += h * s[i].v;
        above = s[i].x;
    }
    return s;
}

}  // namespace sweep_past_a_still_one
