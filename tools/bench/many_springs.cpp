// Many springs: semi-implicit Euler in a plain loop over arrays, over an array of structures, in
// Boost.odeint, and in lanes with one step a pass over memory or several; beside them the STREAM
// triad, which does nothing but fetch and store.

#include "many.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <thread>

#ifdef TIMESTEP_WITH_ODEINT
#include <boost/numeric/odeint.hpp>
#endif

#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/parallel_for.hpp>
#include <timestep/springs.hpp>

using namespace timestep;

namespace {

constexpr long several = 64;  // steps a pass

template <class Real>
[[gnu::noinline]] void plain(const Real* k, Real* x, Real* v, Real h, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
        v[i] += h * (-k[i] * x[i]);
        x[i] += h * v[i];
    }
}

template <class Real>
[[gnu::noinline]] void triad(Real* a, const Real* b, const Real* c, Real s, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + s * c[i];
}

template <class Real>
struct Structure {
    Real k, x, v;
};
template <class Real>
[[gnu::noinline]] void structures(std::vector<Structure<Real>>& all, Real h) {
    for (auto& s : all) {
        s.v += h * (-s.k * s.x);
        s.x += h * s.v;
    }
}

template <class Real>
struct Contest {
    explicit Contest(std::size_t n_) : n(n_) {
        for (std::size_t i = 0; i < n; ++i) {
            const Real omega = Real(1) + Real(i % 100) / 10, at = Real(1) + Real(i % 7);
            springs.add(Spring<Real>(omega), at, 0);
            k.push_back(omega * omega), x.push_back(at), v.push_back(0);
            array.push_back({k.back(), at, 0});
        }
        a = triad_b = triad_c = x;
        several_springs = two_threads = springs;
        odeint_x = x, odeint_v = v;
    }

    std::vector<many::Row> rows() {
        const double once = double(n), many_times = once * double(several);
        std::vector<many::Row> all;
        all.push_back({"plain loop", [this] { plain(k.data(), x.data(), v.data(), h, n); }, once});
        all.push_back({"STREAM triad", [this] { triad(a.data(), triad_b.data(), triad_c.data(), h, n); }, once});
        all.push_back({"array of structures", [this] { structures(array, h); }, once});
#ifdef TIMESTEP_WITH_ODEINT
        all.push_back({"odeint, vector state", [this] { odeint_pass(); }, once});
#endif
        all.push_back({"lanes, a step a pass", [this] { springs.step(semi_implicit_euler, h); }, once});
        all.push_back(
            {"lanes, 64 steps a pass", [this] { several_springs.step(semi_implicit_euler, h, several); }, many_times});
        const unsigned threads = std::max(2u, std::thread::hardware_concurrency());
        all.push_back({std::to_string(threads) + " threads, 64 a pass",
                       [this, threads] {
                           const auto share = [&](std::size_t first, std::size_t last) {
                               two_threads.step(semi_implicit_euler, h, several, first, last);
                           };
                           parallel_for(two_threads.packs(), threads, share);
                       },
                       many_times});
        return all;
    }

    // Do they all take the same steps? Afterwards each has taken some more.
    bool agree(const std::vector<many::Row>& all) {
        for (const auto& row : all)
            for (double steps = 0; steps < double(several) * double(n); steps += row.steps) row.pass();
        const auto& s = springs;
        double worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            worst = std::max(worst, std::fabs(double(s[i].x - x[i])));
            worst = std::max(worst, std::fabs(double(s[i].x - array[i].x)));
            worst = std::max(worst, std::fabs(double(s[i].x - several_springs[i].x)));
            worst = std::max(worst, std::fabs(double(s[i].x - two_threads[i].x)));
#ifdef TIMESTEP_WITH_ODEINT
            worst = std::max(worst, std::fabs(double(s[i].x - odeint_x[i])));
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
    std::vector<Real> k, x, v, a, triad_b, triad_c, odeint_x, odeint_v;
    std::vector<Structure<Real>> array;
    Springs<Real> springs, several_springs, two_threads;
};

double find(const std::vector<many::Row>& rows, const char* name) {
    for (const auto& row : rows)
        if (row.name.find(name) != std::string::npos) return row.nanoseconds;
    return 0;
}

template <class Real>
bool springs_of(const char* real) {
    const std::size_t counts[] = {100, 10000, 1000000};
    std::vector<std::vector<many::Row>> all;
    for (const std::size_t n : counts) {
        Contest<Real> contest(n);
        all.push_back(contest.rows());
        if (!contest.agree(all.back())) return false;
        measure(all.back(), n > 100000 ? 20 : 60);
    }
    std::printf("\n%-34s %10s %10s %10s\n", (std::string("Springs, ns a step, ") + real).c_str(), "100", "10000",
                "1000000");
    for (std::size_t i = 0; i < all[0].size(); ++i) {
        std::printf("%-34s", all[0][i].name.c_str());
        for (const auto& rows : all) std::printf(" %10.3f", rows[i].nanoseconds);
        std::printf("\n");
    }
    const auto& million = all.back();
    const double hand = find(million, "plain loop");
    const double one = find(million, "a step a pass") / hand;
    const double times = hand / find(million, "lanes, 64");
    const double threads = find(million, "lanes, 64") / find(million, "threads");
    // What memory has to move: a spring's three numbers in, two out.
    const double bandwidth = 5 * sizeof(Real) / find(million, "a step a pass");
    const double stream = 4 * sizeof(Real) / find(million, "triad");  // a is fetched, too
    const bool native = std::strstr(BENCH_FLAGS, "native");
    std::printf("at a million: a step a pass %.2f of the plain loop%s\n", one,
                native ? many::target(one, 1.1).c_str() : "");
    std::printf("              64 steps a pass %.1f times as fast%s\n", times,
                native ? many::target(times, 12, false).c_str() : "");
    std::printf("              the threads %.2f times as fast as one\n", threads);
    std::printf("              memory moves %.0f GB/s, in the triad %.0f GB/s\n", bandwidth, stream);
    return true;
}

}  // namespace

int many::springs() {
    if (springs_of<double>("double") && springs_of<float>("float")) return 0;
    std::fprintf(stderr, "bench_many: the loops do not take the same steps\n");
    return 1;
}
