// What the library costs on one spring, beside a loop written by hand and Boost.odeint. Each step depends on the one
// before, so its whole latency counts. `bench_loops_O2` and `bench_loops_O3_native` are this file with those flags.

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#ifdef TIMESTEP_WITH_ODEINT
#include <boost/numeric/odeint.hpp>
#endif

#include <timestep/methods.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "rows.hpp"

namespace {

// One spring, and how to step it. None of it is known to the compiler.
struct Run {
    double omega = 10, h = 1e-3, x = 1, v = 0;
    long steps;
};

// ---- By hand

[[gnu::noinline]] double explicit_euler(Run r) {
    for (long i = 0; i < r.steps; ++i) {
        const double a = -r.omega * r.omega * r.x;
        r.x += r.h * r.v;
        r.v += r.h * a;
    }
    return r.x;
}

[[gnu::noinline]] double semi_implicit_euler(Run r) {
    for (long i = 0; i < r.steps; ++i) {
        r.v += r.h * (-r.omega * r.omega * r.x);
        r.x += r.h * r.v;
    }
    return r.x;
}

[[gnu::noinline]] double implicit_euler(Run r) {
    for (long i = 0; i < r.steps; ++i) {
        r.v = (r.v + r.h * (-r.omega * r.omega * r.x)) / (1 + r.h * r.h * r.omega * r.omega);
        r.x += r.h * r.v;
    }
    return r.x;
}

[[gnu::noinline]] double velocity_verlet(Run r) {
    for (long i = 0; i < r.steps; ++i) {
        const double a1 = -r.omega * r.omega * r.x;
        r.x += r.h * r.v + r.h * r.h / 2 * a1;
        const double a2 = -r.omega * r.omega * r.x;
        r.v = r.v + r.h / 2 * a1 + r.h / 2 * a2;
    }
    return r.x;
}

[[gnu::noinline]] double runge_kutta_4(Run r) {
    const double k = -r.omega * r.omega, h = r.h;
    for (long i = 0; i < r.steps; ++i) {
        const double x1 = r.v, v1 = k * r.x;
        const double x2 = r.v + h / 2 * v1, v2 = k * (r.x + h / 2 * x1);
        const double x3 = r.v + h / 2 * v2, v3 = k * (r.x + h / 2 * x2);
        const double x4 = r.v + h * v3, v4 = k * (r.x + h * x3);
        r.x = r.x + h / 6 * x1 + h / 3 * (x2 + x3) + h / 6 * x4;
        r.v = r.v + h / 6 * v1 + h / 3 * (v2 + v3) + h / 6 * v4;
    }
    return r.x;
}

// ---- Ours

template <class Method>
[[gnu::noinline]] double ours(const Method& method, Run r) {
    return timestep::run(method, timestep::Spring(r.omega), timestep::State{0, r.x, r.v}, r.h, r.steps).x;
}

// ---- Boost.odeint's

using Loop = std::function<double(Run)>;

#ifdef TIMESTEP_WITH_ODEINT
namespace odeint = boost::numeric::odeint;
using One = std::array<double, 1>;
using Two = std::array<double, 2>;

template <class Stepper>
[[gnu::noinline]] double odeint_rate(Stepper stepper, Run r) {
    const auto rate = [k = -r.omega * r.omega](const Two& y, Two& rate, double) {
        rate[0] = y[1];
        rate[1] = k * y[0];
    };
    Two y{r.x, r.v};
    for (long i = 0; i < r.steps; ++i) stepper.do_step(rate, y, double(i) * r.h, r.h);
    return y[0];
}

// It moves the first of a pair with the old second one: for our semi-implicit Euler that is the
// velocity.
[[gnu::noinline]] double odeint_semi_implicit(Run r) {
    const auto acceleration = [k = -r.omega * r.omega](const One& x, One& a) { a[0] = k * x[0]; };
    const auto velocity = [](const One& v, One& rate) { rate[0] = v[0]; };
    odeint::symplectic_euler<One> stepper;
    One x{r.x}, v{r.v};
    for (long i = 0; i < r.steps; ++i)
        stepper.do_step(std::make_pair(acceleration, velocity), v, x, double(i) * r.h, r.h);
    return x[0];
}

[[gnu::noinline]] double odeint_velocity_verlet(Run r) {
    const auto acceleration = [k = -r.omega * r.omega](const One& x, const One&, One& a, double) { a[0] = k * x[0]; };
    odeint::velocity_verlet<One> stepper;
    One x{r.x}, v{r.v};
    for (long i = 0; i < r.steps; ++i)
        stepper.do_step(acceleration, std::make_pair(std::ref(x), std::ref(v)), double(i) * r.h, r.h);
    return x[0];
}

// None for implicit Euler: Boost's needs uBLAS, which does not compile as C++20 in older Boosts.
const Loop odeint_loops[] = {[](Run r) { return odeint_rate(odeint::euler<Two>(), r); }, odeint_semi_implicit, nullptr,
                             odeint_velocity_verlet, [](Run r) { return odeint_rate(odeint::runge_kutta4<Two>(), r); }};
#else
const Loop odeint_loops[5];
#endif

// ---- The table

volatile double sink;

// Times the loops of one method in turns and prints a row. Returns whether they all take the same steps.
template <class Method>
bool compare(const Method& method, const Loop& hand, const Loop& odeint) {
    Run run{};
    run.steps = 10000;
    std::vector<rows::Row> all;
    for (const Loop& loop : {hand, Loop([&](Run r) { return ours(method, r); }), odeint}) {
        if (!loop) continue;
        if (!(std::fabs(loop(run) - hand(run)) < 1e-10)) {
            std::fprintf(stderr, "bench_loops: %s: the loops do not take the same steps\n", Method::name);
            return false;
        }
        all.push_back({Method::name, [=] { sink = loop(run); }, double(run.steps)});
    }
    rows::measure(all, 500);
    const double library = all[1].nanoseconds;
    std::printf("%-21s%10.2f%9.2f%14.3f", Method::name, all[0].nanoseconds, library, library / all[0].nanoseconds);
    if (odeint) std::printf("%9.2f%14.3f", all[2].nanoseconds, library / all[2].nanoseconds);
    std::printf("\n");
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    if (const int refused = rows::refuse_options(argc, argv)) return refused;
    std::printf("%s\n%-21s%10s%9s%14s%9s%14s\n", BENCH_FLAGS, "ns per step", "by hand", "ours", "ours over it",
                "odeint", "ours over it");
    const bool good = compare(timestep::explicit_euler, explicit_euler, odeint_loops[0]) &&
                      compare(timestep::semi_implicit_euler, semi_implicit_euler, odeint_loops[1]) &&
                      compare(timestep::implicit_euler, implicit_euler, odeint_loops[2]) &&
                      compare(timestep::velocity_verlet, velocity_verlet, odeint_loops[3]) &&
                      compare(timestep::runge_kutta_4, runge_kutta_4, odeint_loops[4]);
    std::printf("\n");
    return good ? 0 : 1;
}
