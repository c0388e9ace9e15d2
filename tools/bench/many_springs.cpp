// Many springs: semi-implicit Euler in a plain loop over arrays, in Boost.odeint, and in lanes, with one step per pass
// over memory or several.

#include <cmath>
#include <cstdio>

#ifdef TIMESTEP_WITH_ODEINT
#include <boost/numeric/odeint.hpp>
#endif

#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/springs.hpp>

#include "rows.hpp"

using namespace timestep;

namespace {

constexpr long several = 64;  // steps per pass

template <class Real>
[[gnu::noinline]] void plain(const Real* k, Real* x, Real* v, Real h, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        v[i] += h * (-k[i] * x[i]);
        x[i] += h * v[i];
    }
}

template <class Real>
struct Crowd {
    explicit Crowd(std::size_t n_) : n(n_) {
        for (std::size_t i = 0; i < n; ++i) {
            const Real omega = Real(1) + Real(i % 100) / 10, at = Real(1) + Real(i % 7);
            springs.add(Spring<Real>(omega), at, 0);
            k.push_back(omega * omega), x.push_back(at), v.push_back(0);
        }
        several_springs = springs;
        odeint_x = x, odeint_v = v;
    }

    std::vector<rows::Row> make_rows() {
        const double once = double(n);
        return {{"plain loop", [this] { plain(k.data(), x.data(), v.data(), h, n); }, once},
#ifdef TIMESTEP_WITH_ODEINT
                {"odeint, vector state", [this] { odeint_pass(); }, once},
#endif
                {"lanes, a step per pass", [this] { springs.step(semi_implicit_euler, h); }, once},
                {"lanes, 64 steps per pass", [this] { several_springs.step(semi_implicit_euler, h, several); },
                 once * double(several)}};
    }

    // Do they all take the same steps? Afterwards each has taken some more.
    bool agree(const std::vector<rows::Row>& all) {
        for (const auto& row : all)
            for (double steps = 0; steps < double(several) * double(n); steps += row.steps) row.pass();
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            worst = std::max(worst, std::fabs(double(springs[i].x - x[i])));
            worst = std::max(worst, std::fabs(double(springs[i].x - several_springs[i].x)));
#ifdef TIMESTEP_WITH_ODEINT
            worst = std::max(worst, std::fabs(double(springs[i].x - odeint_x[i])));
#endif
        }
        return worst < 1e-3;  // of places up to 7, after 64 ms
    }

#ifdef TIMESTEP_WITH_ODEINT
    // It moves the first of a pair with the old second one, which is the velocity.
    void odeint_pass() {
        const auto acceleration = [this](const std::vector<Real>& at, std::vector<Real>& rate) {
            for (std::size_t i = 0; i < n; ++i) rate[i] = -k[i] * at[i];
        };
        const auto velocity = [this](const std::vector<Real>& at, std::vector<Real>& rate) {
            for (std::size_t i = 0; i < n; ++i) rate[i] = at[i];
        };
        stepper.do_step(std::make_pair(acceleration, velocity), odeint_v, odeint_x, Real(0), h);
    }
    boost::numeric::odeint::symplectic_euler<std::vector<Real>, std::vector<Real>, Real> stepper;
#endif

    std::size_t n;
    Real h = Real(1e-3);
    std::vector<Real> k, x, v, odeint_x, odeint_v;
    Springs<Real> springs, several_springs;
};

template <class Real>
bool springs_of(const char* real) {
    std::vector<std::vector<rows::Row>> all;
    for (const std::size_t n : {100, 10000, 1000000}) {
        Crowd<Real> crowd(n);
        all.push_back(crowd.make_rows());
        if (!crowd.agree(all.back())) return false;
        measure(all.back(), n > 100000 ? 20 : 60);
    }
    std::printf("\n%-34s %10s %10s %10s\n", (std::string("Springs, ns per step, ") + real).c_str(), "100", "10000",
                "1000000");
    for (std::size_t i = 0; i < all[0].size(); ++i) {
        std::printf("%-34s", all[0][i].name.c_str());
        for (const auto& table : all) std::printf(" %10.3f", table[i].nanoseconds);
        std::printf("\n");
    }
    return true;
}

}  // namespace

int many_springs() {
    if (springs_of<double>("double") && springs_of<float>("float")) return 0;
    std::fprintf(stderr, "bench_many: the loops do not take the same steps\n");
    return 1;
}
