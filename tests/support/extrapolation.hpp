#pragma once
// A reference that shares nothing with the library's methods: extrapolation to step zero.

#include <array>

namespace test_support {

// y at t + `steps` · `h` for ẏ = f(t, y), after Gragg, Bulirsch and Stoer: cross each step with
// the modified midpoint rule in 2, 4, …, 16 small steps. Its error is a series in the square of
// the small step, so a polynomial through the eight answers, read off at zero, cancels seven terms
// of it: order 16.
template <class System, class Y, class Real>
Y extrapolated(const System& f, Y y, Real t, Real h, long steps) {
    constexpr int levels = 8;
    for (long step = 0; step < steps; ++step, t += h) {
        std::array<Y, levels> answer;
        for (int j = 0; j < levels; ++j) {
            const int n = 2 * (j + 1);
            const Real small = h / n;
            Y before = y;
            Y now = y + small * f(t, y);
            for (int i = 1; i < n; ++i) {
                const Y next = before + 2 * small * f(t + i * small, now);
                before = now;
                now = next;
            }
            answer[j] = (before + now + small * f(t + h, now)) / 2;
            // Neville's scheme: (j + 1)² / (j + 1 − k)² is the ratio of the small steps, squared.
            for (int k = j - 1; k >= 0; --k) {
                const Real ratio = Real(j + 1) / (k + 1);
                answer[k] = answer[k + 1] + (answer[k + 1] - answer[k]) / (ratio * ratio - 1);
            }
        }
        y = answer[0];
    }
    return y;
}

}  // namespace test_support
