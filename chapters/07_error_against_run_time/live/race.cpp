// Who is accurate enough in the least time? Four methods race on one spring, in this very browser.
// not the same bits: the clock
// still: steps=800

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/velocity_verlet.hpp>
#include <timestep/models/spring.hpp>

#include "live.hpp"

using namespace timestep;

constexpr std::tuple methods{explicit_euler, semi_implicit_euler, velocity_verlet, runge_kutta_4};
constexpr std::size_t most_rates = 15;  // 15 Hz, 30 Hz, 60 Hz, and so on
constexpr double never = std::numeric_limits<double>::infinity();

// In 1/15 s the spring turns by an angle of the triangle 5, 12, 13: so the truth needs no sine. It is nearly one
// oscillation a second.
constexpr double omega = 15 * 0.39479111969976155;  // rad/s
constexpr long looks = 60;                          // every 1/15 s: four seconds of game

// One method's points: of a rate the largest error, m, and the best time of a run so far, µs.
struct Runner {
    template <class Method>
    Runner(live::Panel* panel, const Method& method)
        : name(method.name), rates(method.order < 4 ? most_rates : 12), needs{panel, name, "µs"} {}

    // What an accuracy takes, on the straight lines between the points.
    double time_for(double wanted) const {
        if (measured > 0 && error[0] <= wanted) return time[0];
        for (std::size_t k = 1; k < measured; ++k) {
            const double share = std::log(wanted / error[k - 1]) / std::log(error[k] / error[k - 1]);
            if (error[k] <= wanted) return time[k - 1] * std::pow(time[k] / time[k - 1], share);
        }
        return never;
    }

    const char* name;
    std::size_t rates;    // the last of Runge-Kutta 4 are all roundoff
    live::Readout needs;  // the time for the accuracy that is wanted
    std::array<double, most_rates> error{}, time{};
    std::array<long, most_rates> batch{};  // so many runs the clock can see
    std::size_t measured = 0;  // so many rates
};

class Race : public live::Panel {
public:
    Race() {
        title = "Error against time";
        aspect = 0.8, aspect_narrow = 1.1;
    }

    void restart() override {
        for (Runner& runner : runners) runner.measured = 0, runner.needs.not_yet();
        turn = 0;
    }
    double seconds() const override { return 1.0 / 30; }
    bool restarts(const live::Control&) const override { return false; }  // what has been measured stays so

    // At first nothing counts: a browser compiles what runs often once more, and until then all of it is slow. Then
    // one batch of one method at one rate. They take turns, so that a bad moment hits all.
    void step() override {
        std::size_t i = 0;
        if (steps <= warm) {
            std::apply([&](const auto&... method) { (warm_up(method, i++), ...); }, methods);
            return;
        }
        const auto measure_in_turn = [&](const auto& method) {
            if (i++ == turn % runners.size()) measure(method, runners[i - 1], turn / runners.size());
        };
        std::apply([&](const auto&... method) { (measure_in_turn(method), ...); }, methods);
        turn = (turn + 1) % (runners.size() * most_rates);
        for (Runner& runner : runners) {
            const double time = runner.time_for(wanted / 100);  // that none gets there, only all of its rates can say
            time < never || runner.measured == runner.rates ? runner.needs = time : runner.needs.not_yet();
        }
    }

    void draw(live::Picture& p) const override {
        p.window(-1.4, 4.4, -15.5, 2.8);
        p.axes("time of the run, µs", "largest error, m", true, true);
        const double level = std::log10(wanted / 100);
        p.ink("ink", 1.5, 0.6);
        p.segment(-1.4, level, 4.4, level);
        const Runner* first = nullptr;
        double least = never, last_x = 0, last_y = 0;
        for (const Runner& runner : runners) {
            p.ink(runner.name, 2);
            for (std::size_t k = 0; k < runner.measured; ++k) {
                const double x = std::log10(runner.time[k]), y = std::fmin(std::log10(runner.error[k]), 1.4);
                if (k > 0) p.segment(last_x, last_y, x, y);
                p.dot(x, y, k == 2 ? 5 : 2.5);  // 60 Hz is larger
                last_x = x, last_y = y;
            }
            const double time = runner.time_for(wanted / 100);
            if (time < least) least = time, first = &runner;
        }
        p.ink("ink");
        const Runner& last = runners.back();
        if (last.measured > 0) p.text(std::log10(last.time[0]) - 0.7, std::log10(last.error[0]) - 0.2, "15 Hz");
        if (last.measured > 2) p.text(std::log10(last.time[2]) - 0.7, std::log10(last.error[2]) - 0.2, "60 Hz");
        const bool all_known = std::all_of(runners.begin(), runners.end(), [](const Runner& r) { return r.needs.known; });
        if (!all_known) return p.text(2.3, 2.1, steps <= warm ? "warming up" : "first there: not all are that far yet");
        if (!first) return;
        p.dot(std::log10(least), level, 7);
        p.text(2.3, 2.1, "first there:");
        p.ink(first->name);
        p.text(2.3, 1.3, first->name);
    }

    // The line of the accuracy that is wanted.
    bool grab(double, double y) override { return std::fabs(y - std::log10(wanted / 100)) < 1; }
    void drag(double, double y) override { set(wanted, std::pow(10, 2 + y)); }
    bool handle(double& x, double& y) const override { return x = 2, y = std::log10(wanted / 100), true; }

private:
    static constexpr long warm = 24;  // steps
    template <class Method>
    void warm_up(const Method& method, std::size_t i) {
        if (i != static_cast<std::size_t>(steps) % runners.size()) return;
        State<double> state{0, 1, 0};
        for (const double begin = live::clock(); live::clock() - begin < 8;) advance(method, state, looks << 4, h(1L << 4));
        warmed = state.x;
    }
    template <class Method>
    void measure(const Method& method, Runner& runner, std::size_t rate) {
        if (rate >= runner.rates) return;
        if (rate == runner.measured) {  // for the first time
            runner.error[rate] = error(method, 1L << rate);
            runner.time[rate] = 1e9;
            runner.batch[rate] = 1;
            runner.measured = rate + 1;
        }
        // A clock cannot see a run that takes 100 ns. So we time as many as take two milliseconds.
        volatile double pulled = 1, read = 0;  // what nobody reads, or what is the same again, a compiler leaves out
        for (long& runs = runner.batch[rate]; runs < 1 << 20; runs *= 2) {
            const double begin = live::clock();
            for (long run = 0; run < runs; ++run) {
                State<double> state{0, pulled, 0};
                advance(method, state, looks << rate, h(1L << rate));
                read = state.x;
            }
            const double took = live::clock() - begin;
            if (took < 2) continue;
            // Whatever else the machine does makes a run longer, nothing makes it shorter: the best counts.
            runner.time[rate] = std::fmin(runner.time[rate], 1000 * took / static_cast<double>(runs));
            break;
        }
        // Half the steps never take longer than all of them: what says so was disturbed.
        for (std::size_t k = runner.measured; k-- > 1;) runner.time[k - 1] = std::fmin(runner.time[k - 1], runner.time[k]);
        (void)read;
    }
    static double h(long steps_a_look) { return 1.0 / 15 / static_cast<double>(steps_a_look); }
    template <class Method>
    static void advance(const Method& method, State<double>& state, long steps, double h) {
        const Spring spring(omega);
        for (long n = 0; n < steps; ++n) state = method.step(spring, state, h);
    }
    // The largest of all looks. Not timed: to look takes time.
    template <class Method>
    static double error(const Method& method, long steps_a_look) {
        State<double> state{0, 1, 0};
        double x = 1, u = 0, worst = 0;  // the truth; u is v/ω
        for (long look = 0; look < looks; ++look) {
            advance(method, state, steps_a_look, h(steps_a_look));
            const double next = (12 * x + 5 * u) / 13;
            u = (12 * u - 5 * x) / 13, x = next;
            worst = std::fmax(worst, std::fabs(state.x - x));
        }
        return std::fmax(worst, 1e-16);  // its logarithm is drawn
    }

    live::LogSlider wanted{this, "wanted", "wanted error", 1e-13, 100, 10, "%"};
    std::array<Runner, 4> runners = std::apply(
        [this](const auto&... method) { return std::array{Runner(this, method)...}; }, methods);
    std::size_t turn = 0;
    volatile double warmed = 0;  // what nobody reads a compiler leaves out
};
LIVE_PANEL(Race)
