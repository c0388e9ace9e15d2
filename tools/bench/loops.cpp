// What the library costs on one spring, beside a loop written by hand and Boost.odeint. Each step depends on the one
// before, so its whole latency counts. `bench_loops_O2` and `bench_loops_O3_native` are this file with those flags.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#ifdef TIMESTEP_WITH_ODEINT
#include <boost/numeric/odeint.hpp>
#endif

#include <timestep/methods.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>

#include "timing.hpp"

namespace {

constexpr double most_by_hand = 1.05, most_odeint = 1.0;  // the targets: our time over the other's

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

// Its implicit Euler needs uBLAS, which does not compile as C++20 in older Boosts.
const Loop odeint_loops[] = {[](Run r) { return odeint_rate(odeint::euler<Two>(), r); }, odeint_semi_implicit, nullptr,
                             odeint_velocity_verlet, [](Run r) { return odeint_rate(odeint::runge_kutta4<Two>(), r); }};
#else
const Loop odeint_loops[5];
#endif

// ---- The contest

struct Contestant {
    Loop loop;
    double nanoseconds = 1e9;  // a step
};

struct Row {
    const char* method;
    Contestant hand, ours, odeint;
    template <class Visit>
    void each(const Visit& visit) {
        for (Contestant* c : {&hand, &ours, &odeint})
            if (c->loop) visit(*c);
    }
};

template <class Method>
Row row(const Method& method, const Loop& hand, const Loop& odeint) {
    return {Method::name, {hand}, {[&method](Run r) { return ours(method, r); }}, {odeint}};
}

std::vector<Row> make_rows() {
    return {row(timestep::explicit_euler, explicit_euler, odeint_loops[0]),
            row(timestep::semi_implicit_euler, semi_implicit_euler, odeint_loops[1]),
            row(timestep::implicit_euler, implicit_euler, odeint_loops[2]),
            row(timestep::velocity_verlet, velocity_verlet, odeint_loops[3]),
            row(timestep::runge_kutta_4, runge_kutta_4, odeint_loops[4])};
}

volatile double sink;

Run run_of(long steps) {
    Run run{};
    run.steps = steps;
    return run;
}

// They must agree before they are compared.
bool agree(std::vector<Row>& rows) {
    bool good = true;
    for (Row& row : rows) {
        const double expected = row.hand.loop(run_of(10000));
        row.each([&](Contestant& c) {
            if (std::fabs(c.loop(run_of(10000)) - expected) < 1e-10) return;
            std::fprintf(stderr, "bench_loops: %s: the loops do not take the same steps\n", row.method);
            good = false;
        });
    }
    return good;
}

// All loops in turns; the fastest turn of each is the least disturbed.
void measure_times(std::vector<Row>& rows) {
    constexpr long steps = 10000;
    for (int turn = 0; turn < 500; ++turn)
        for (Row& row : rows)
            row.each([&](Contestant& c) {
                const double seconds = lab::seconds_of([&] { sink = c.loop(run_of(steps)); });
                c.nanoseconds = std::min(c.nanoseconds, 1e9 * seconds / steps);
            });
}

std::string words(const char* format, double value) {
    char text[32];
    std::snprintf(text, sizeof text, format, value);
    return value > 0 ? text : "-";
}

void print(const std::vector<Row>& rows) {
    std::printf("%s\n%-21s%28s   %25s\n", BENCH_FLAGS, "", "ns a step", "ours over");
    std::printf("%-21s%10s%9s%9s   %13s%12s\n", "", "by hand", "ours", "odeint", "by hand", "odeint");
    for (const Row& row : rows) {
        const double hand = row.hand.nanoseconds, ours = row.ours.nanoseconds;
        const double odeint = row.odeint.loop ? row.odeint.nanoseconds : 0, over = odeint > 0 ? ours / odeint : 0;
        std::string misses = ours > most_by_hand * hand ? "  misses: time by hand" : "";
        if (over > most_odeint + 0.02) misses += misses.empty() ? "  misses: odeint's time" : ", odeint's time";
        std::printf("%-21s%10s%9s%9s   %13s%12s%s\n", row.method, words("%.2f", hand).c_str(),
                    words("%.2f", ours).c_str(), words("%.2f", odeint).c_str(), words("%.3f", ours / hand).c_str(),
                    words("%.3f", over).c_str(), misses.c_str());
    }
    std::printf("%-21s%28s   %13.2f%12.2f\n", "targets, at most", "", most_by_hand, most_odeint);
    std::printf("A miss against odeint is marked from 2 %% on: the clock tells no less.\n");
}

}  // namespace

int main(int argc, char** argv) {
    auto rows = make_rows();
    if (argc > 1) return std::fprintf(stderr, "bench_loops: %s: takes no options\n", argv[1]), 2;
    if (!agree(rows)) return 1;
    measure_times(rows);
    print(rows);
    std::printf("\n");
}
