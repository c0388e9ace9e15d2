#include "exercise.hpp"

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    const double a = h * h * k, beside = -a;
    std::vector<double> diagonal(n), right(n);
    for (std::size_t i = 0; i < n; ++i) {
        const double above = (i > 0 ? s[i - 1].x : 0) - s[i].x;
        const double below = i + 1 < n ? s[i + 1].x - s[i].x : 0;
        right[i] = m * s[i].v + h * k * (above + below);
        diagonal[i] = m + (i + 1 < n ? 2 : 1) * a;
    }
    for (std::size_t i = 1; i < n; ++i) {
        const double share = beside / diagonal[i - 1];
        right[i] -= share * right[i - 1];
    }
    for (std::size_t i = n; i-- > 0;) {
        s[i].v = (right[i] - (i + 1 < n ? beside * s[i + 1].v : 0)) / diagonal[i];
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}
