// Chapter 7: four methods, what each costs, and how wrong it is.
//
//   c++ -std=c++20 -O2 -Iinclude chapters/07_error_against_run_time/error_against_run_time.cpp -o work && ./work

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/models/spring.hpp>

using namespace timestep;
using Clock = std::chrono::steady_clock;

// Play with these.
const double omega = 6.283185307;  // rad/s: one oscillation a second
const double seconds = 4;          // of game

const int rates[] = {15, 30, 60, 120, 240, 480, 960, 1920};  // steps a second

const Spring spring(omega);
const State<double> start{0, 1.0, 0.0};

// How far it ever is from the truth, m. Not timed: to look at a state takes longer than to step it.
template <class Method>
double error(const Method& method, double h, int steps) {
    State state = start;
    double worst = 0;
    for (int n = 1; n <= steps; ++n) {
        state = method.step(spring, state, h);
        worst = std::max(worst, std::abs(state.x - spring.exact(start, n * h).x));
    }
    return worst;
}

// The best of twenty, s: whatever else the machine does makes a run longer, nothing makes it shorter. A clock cannot
// see a run that takes 100 ns: a batch of them is timed, of 20000 steps or more.
template <class Method>
double time(const Method& method, double h, int steps) {
    const int batch = 1 + 20000 / (1 + steps);
    volatile double pulled = start.x, read = 0;  // what nobody reads, or what is the same again, a compiler leaves out
    double best = 1e9;
    for (int again = 0; again < 20; ++again) {
        const auto begin = Clock::now();
        for (int run = 0; run < batch; ++run) {
            State state{start.t, pulled, start.v};
            for (int n = 0; n < steps; ++n) state = method.step(spring, state, h);
            read = state.x;
        }
        const double took = std::chrono::duration<double>(Clock::now() - begin).count();
        best = std::min(best, took / batch);
    }
    (void)read;
    return best;
}

int main() {
    std::ofstream data("work.dat");
    std::printf("%22s %8s %12s %12s\n", "", "Hz", "error, m", "time, µs");
    const auto look_at = [&](const auto& method) {
        data << "# " << method.name << '\n';
        for (const int rate : rates) {
            const int steps = static_cast<int>(seconds * rate);
            const double wrong = error(method, 1.0 / rate, steps), took = 1e6 * time(method, 1.0 / rate, steps);
            data << took << ' ' << wrong << ' ' << rate << '\n';
            std::printf("%22s %8d %12.2g %12.2g\n", method.name, rate, wrong, took);
        }
        data << "\n\n";
    };
    look_at(explicit_euler);
    look_at(semi_implicit_euler);
    look_at(velocity_verlet);
    look_at(runge_kutta_4);
    if (!data.flush()) return std::cerr << "work.dat: cannot be written\n", 2;
}
