#include "exercise.hpp"

std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::vector<State<double>> old = s;
    for (std::size_t i = 0; i < s.size(); ++i) {
        double force = -k * (old[i].x - (i > 0 ? old[i - 1].x : 0));
        if (i + 1 < s.size()) force += k * (old[i + 1].x - old[i].x);
        s[i].v += h * force / m;
        s[i].x += h * s[i].v;
        s[i].t += h;
    }
    return s;
}
