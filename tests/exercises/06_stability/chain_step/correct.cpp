#include "exercise.hpp"

namespace from_below {

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

}  // namespace from_below

namespace gradients {

using Row = std::vector<double>;

// K y: every link pulls at its ends.
static Row k_times(const Row& y, double k) {
    Row result(y.size());
    double above = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double pull = k * (y[i] - above);
        result[i] += pull;
        if (i > 0) result[i - 1] -= pull;
        above = y[i];
    }
    return result;
}

static double dot(const Row& a, const Row& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

// Conjugate gradients.
std::vector<State<double>> chain_step(std::vector<State<double>> s, double m, double k, double h) {
    const std::size_t n = s.size();
    Row x(n), v(n), left(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = s[i].x, v[i] = s[i].v;
    const auto times = [&](const Row& y) {
        Row result = k_times(y, h * h * k);
        for (std::size_t i = 0; i < n; ++i) result[i] += m * y[i];
        return result;
    };
    const Row pulled = k_times(x, h * k), product = times(v);
    for (std::size_t i = 0; i < n; ++i) left[i] = m * v[i] - pulled[i] - product[i];
    Row direction = left;
    double size = dot(left, left);
    const double enough = 1e-28 * size;
    const std::size_t rounds = 50 + 3 * n;  // n of them, but for roundoff
    for (std::size_t round = 0; round < rounds && size > enough; ++round) {
        const Row along = times(direction);
        const double far = size / dot(direction, along);
        for (std::size_t i = 0; i < n; ++i) {
            v[i] += far * direction[i];
            left[i] -= far * along[i];
        }
        const double smaller = dot(left, left);
        for (std::size_t i = 0; i < n; ++i) direction[i] = left[i] + smaller / size * direction[i];
        size = smaller;
    }
    for (std::size_t i = 0; i < n; ++i) s[i] = {s[i].t + h, x[i] + h * v[i], v[i]};
    return s;
}

}  // namespace gradients
