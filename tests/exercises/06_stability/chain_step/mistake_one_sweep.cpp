#include "exercise.hpp"

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k;
    std::vector<double> right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
    }
    for (int sweep = 0; sweep < 1; ++sweep)
        for (std::size_t i = 0; i < n; ++i) {
            const double up = i > 0 ? s[i - 1].v : 0, down = i + 1 < n ? s[i + 1].v : 0;
            s[i].v = (right[i] + a * (up + down)) / (m + (i + 1 < n ? 2 : 1) * a);
        }
    for (auto& [t, x, v] : s) t += h, x += h * v;
    return s;
}
