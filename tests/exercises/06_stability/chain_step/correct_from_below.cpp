#include "exercise.hpp"

// From the free end upwards: what hangs below a mass answers with v2 = free + follows v2_above.
std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const double stiff = h * h * k / m;
    std::vector<double> free(s.size() + 1), follows(s.size() + 1);
    follows.back() = 1;  // below the last mass a link that never pulls
    for (std::size_t i = s.size(); i-- > 0;) {
        double place = 0;  // where the links would have it, beside x1
        if (i > 0)
            place += s[i - 1].x - s[i].x;
        else
            place -= s[i].x;
        if (i + 1 < s.size()) place += s[i + 1].x - s[i].x;
        const double divisor = 1 + stiff * (1 + (1 - follows[i + 1]));
        follows[i] = stiff / divisor;
        free[i] = (s[i].v + h * k / m * place + stiff * free[i + 1]) / divisor;
    }
    double above = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
        above = s[i].v = free[i] + follows[i] * above;
        s[i].t += h;
        s[i].x += h * above;
    }
    return s;
}
