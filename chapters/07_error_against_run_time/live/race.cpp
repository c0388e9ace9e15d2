// Who is accurate enough in the least time? Four methods race on one spring, in this very browser.
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
#include <timestep/models/tether.hpp>
#include <timestep/own_math.hpp>

#include "live.hpp"

using namespace timestep;

constexpr std::tuple methods{explicit_euler, semi_implicit_euler, velocity_verlet, runge_kutta_4};
constexpr std::size_t most_rates = 15;  // 15 Hz, 30 Hz, 60 Hz, and so on
constexpr double never = std::numeric_limits<double>::infinity();

constexpr double omega = 6.283185307179586;  // rad/s: one oscillation a second
constexpr long looks = 60;                   // every 1/15 s: four seconds of game

// The other scene: a tether on a line. It draws the mass to the nearer of two places, so the force
// jumps halfway.
constexpr double nearer = 0.25;                 // m: there, and as far on the other side
constexpr double quarter = 1.9106332362490186;  // rad, from one metre to the middle: its cosine is −1/3

// One method's points: of a rate the largest error, m, and the best time of a run so far, µs; both
// as powers of ten.
struct Runner {
    template <class Method>
    Runner(live::Panel* panel, const Method& method)
        : name(method.name), rates(method.order < 4 ? most_rates : 12), needs{panel, name, "µs"} {}

    // What an accuracy takes, on the straight lines between the points.
    double time_for(double wanted) const {
        if (measured > 0 && error[0] <= wanted) return time[0];
        for (std::size_t k = 1; k < measured; ++k)
            if (error[k] <= wanted)
                return time[k - 1] + (wanted - error[k - 1]) / (error[k] - error[k - 1]) * (time[k] - time[k - 1]);
        return never;
    }

    const char* name;
    std::size_t rates;    // the last of Runge-Kutta 4 are all roundoff
    live::Readout needs;  // the time for the accuracy that is wanted
    std::array<double, most_rates> error{}, time{};
    std::array<long, most_rates> batch{};  // so many runs the clock can see
    std::size_t measured = 0;              // so many rates
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
    bool restarts(const live::Control& c) const override {
        return &c == &scene;
    }  // else what has been measured stays so

    // At first nothing counts: a browser compiles what runs often once more, and until then all of
    // it is slow. Then one batch of one method at one rate. They take turns, so that a bad moment
    // hits all.
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
            const double time = runner.time_for(level());  // that none gets there, only all of its rates can say
            if (time < never)
                runner.needs = live::power_of_ten(time);
            else if (runner.measured == runner.rates)
                runner.needs = never;
            else
                runner.needs.not_yet();
        }
    }

    void draw(live::Picture& p) const override {
        p.window(-1.4, 4.4, -15.5, 2.8);
        p.axes("time of the run, µs", "largest error, m", true, true);
        p.ink("ink", 1.5, 0.6);
        p.segment(-1.4, level(), 4.4, level());
        const Runner* first = nullptr;
        double least = never, last_x = 0, last_y = 0;
        for (const Runner& runner : runners) {
            p.ink(runner.name, 2);
            for (std::size_t k = 0; k < runner.measured; ++k) {
                const double x = runner.time[k], y = std::fmin(runner.error[k], 1.4);
                if (k > 0) p.segment(last_x, last_y, x, y);
                p.dot(x, y, k == 2 ? 5 : 2.5);  // 60 Hz is larger
                last_x = x, last_y = y;
            }
            const double time = runner.time_for(level());
            if (time < least) least = time, first = &runner;
        }
        p.ink("ink");
        const Runner& last = runners.back();
        if (last.measured > 0) p.text(last.time[0] - 0.7, last.error[0] - 0.2, "15 Hz");
        if (last.measured > 2) p.text(last.time[2] - 0.7, last.error[2] - 0.2, "60 Hz");
        const bool all_known =
            std::all_of(runners.begin(), runners.end(), [](const Runner& r) { return r.needs.known; });
        if (steps <= warm) return p.text(1.7, 2.1, "warming up");
        if (all_known && !first) return;  // none gets there
        p.text(1.7, 2.1, "first there:");
        if (!all_known) return p.text(1.7, 1.3, "not yet known");
        p.dot(least, level(), 7);
        p.ink(first->name);
        p.text(1.7, 1.3, first->name);
    }

    // The line of the accuracy that is wanted.
    bool grab(double, double y) override { return std::fabs(y - level()) < 1; }
    void drag(double, double y) override { set(wanted, live::power_of_ten(2 + y)); }
    bool handle(double& x, double& y) const override { return x = 2, y = level(), true; }

private:
    static constexpr long warm = 24;                            // steps
    double level() const { return live::log10(wanted / 100); }  // the wanted error, as a power of ten
    template <class Method>
    void warm_up(const Method& method, std::size_t i) {
        if (i != static_cast<std::size_t>(steps) % runners.size()) return;
        State<double> state{0, 1, 0};
        for (const double begin = live::clock(); live::clock() - begin < 8;)
            advance(method, state, looks << 4, h(1L << 4));
        warmed = state.x;
    }
    template <class Method>
    void measure(const Method& method, Runner& runner, std::size_t rate) {
        if (rate >= runner.rates) return;
        if (rate == runner.measured) {  // for the first time
            runner.error[rate] = live::log10(error(method, 1L << rate));
            runner.time[rate] = 9;
            runner.batch[rate] = 1;
            runner.measured = rate + 1;
        }
        // A clock cannot see a run that takes 100 ns. So we time as many as take two milliseconds.
        volatile double pulled = 1,
                        read = 0;  // what nobody reads, or what is the same again, a compiler leaves out
        for (long& runs = runner.batch[rate]; runs < 1 << 20; runs *= 2) {
            const double begin = live::clock();
            for (long run = 0; run < runs; ++run) {
                State<double> state{0, pulled, 0};
                advance(method, state, looks << rate, h(1L << rate));
                read = state.x;
            }
            const double took = live::clock() - begin;
            if (took < 2) continue;
            // Whatever else the machine does makes a run longer, nothing makes it shorter: the best
            // counts.
            runner.time[rate] = std::fmin(runner.time[rate], live::log10(1000 * took / static_cast<double>(runs)));
            break;
        }
        // Half the steps never take longer than all of them: what says so was disturbed.
        for (std::size_t k = runner.measured; k-- > 1;)
            runner.time[k - 1] = std::fmin(runner.time[k - 1], runner.time[k]);
        (void)read;
    }
    static double h(long steps_a_look) { return 1.0 / 15 / static_cast<double>(steps_a_look); }
    template <class Method>
    void advance(const Method& method, State<double>& state, long steps, double h) const {
        scene == 0 ? advance(method, Spring(omega), state, steps, h)
                   : advance(method, Tether(omega, nearer), state, steps, h);
    }
    template <class Method, class Force>
    static void advance(const Method& method, const Force& force, State<double>& state, long steps, double h) {
        for (long n = 0; n < steps; ++n) state = method.step(force, state, h);
    }
    // The true place after this many looks; by the tether each way from one side to the other is
    // the last one, mirrored.
    double truth(long look) const {
        if (scene == 0) return sine_cosine(omega * (look % 15) / 15.0).cosine;
        const double turned = omega * look / 15.0, ways = std::floor(turned / (2 * quarter) + 0.5);
        const double x = nearer + (1 - nearer) * sine_cosine(turned - 2 * quarter * ways).cosine;
        return std::fmod(ways, 2) == 0 ? x : -x;
    }
    // The largest of all looks. Not timed: to look takes time.
    template <class Method>
    double error(const Method& method, long steps_a_look) const {
        State<double> state{0, 1, 0};
        double worst = 1e-16;  // its logarithm is drawn
        for (long look = 1; look <= looks; ++look) {
            advance(method, state, steps_a_look, h(steps_a_look));
            worst = std::fmax(worst, std::fabs(state.x - truth(look)));
        }
        return worst;
    }

    live::Choice scene{this, "scene", "scene", "a spring|a force that jumps"};
    live::LogSlider wanted{this, "wanted", "wanted error", 1e-13, 100, 10, "%"};
    std::array<Runner, 4> runners =
        std::apply([this](const auto&... method) { return std::array{Runner(this, method)...}; }, methods);
    std::size_t turn = 0;
    volatile double warmed = 0;  // what nobody reads a compiler leaves out
};
LIVE_PANEL(Race)
