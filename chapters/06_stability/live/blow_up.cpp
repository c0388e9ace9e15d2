// Will it blow up? Your own spring, mass, damper and rate: what each method's formula says, and
// what its steps do. still: steps=60

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <tuple>

#include <timestep/models/damped_spring.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_limit.hpp>
#include "live.hpp"

using namespace timestep;

// Those that take a damper. Verlet, velocity Verlet and leapfrog do not; without one they go as
// semi-implicit Euler.
constexpr std::tuple methods{explicit_euler,
                             semi_implicit_euler,
                             semi_implicit_euler_new_damping,
                             midpoint,
                             runge_kutta_4,
                             implicit_euler,
                             implicit_midpoint,
                             bdf2};
constexpr std::size_t most_samples = 600;                 // of a run
constexpr std::size_t most_exact = 2 * most_samples + 1;  // of the true motion

// A run of one method.
struct Run {
    template <class Method>
    Run(live::Panel* panel, const Method& method)
        : name(method.name), off{panel, name, "% off"}, holds{panel, name}, limit([](double zeta) {
              return stability_limit(Method{}, zeta).value;
          }) {}
    double drawn_limit(double zeta) const { return static_cast<float>(limit(zeta)); }  // std::hypot's last bit varies
    bool has_limit() const { return std::isfinite(limit(0)); }

    const char* name;
    live::Readout off;  // under the method's name: how far from the truth it was in the first period
    live::Fuse holds;
    double (*limit)(double zeta);  // the longest stable ωh
    char verdict[48] = "";
    State<double> now{}, before{};   // BDF2 builds on two
    double samples[most_samples]{};  // the last positions, in a ring
    std::size_t end = 0;             // where they end: here, or where it blew up
};

// Two steps in one.
inline StepMatrix<double> twice(const StepMatrix<double>& a) {
    return {a.xx * a.xx + a.xv * a.vx, a.xx * a.xv + a.xv * a.vv, a.vx * a.xx + a.vv * a.vx, a.vx * a.xv + a.vv * a.vv};
}

class BlowUp : public live::Panel {
public:
    BlowUp() { title = "Will it blow up?", aspect = 0.75, aspect_narrow = 2; }

    void restart() override {
        const DampedSpring<double> spring = this->spring();
        h = 1 / rate, s = spring.omega * h;
        omega_h = s, zeta = spring.zeta;
        // What the map and the plane cannot show they tell.
        std::snprintf(outside[0], sizeof outside[0], "→ ζ = %.3g", zeta.value);
        std::snprintf(outside[1], sizeof outside[1], "↑ ωh = %.3g", s);
        const double real = zeta.value * s, apart = real * real - s * s, root = std::sqrt(std::fabs(apart));
        const double left = real + (apart > 0 ? root : 0), up = apart > 0 ? 0 : root;
        outside[2][0] = '\0';
        if (left > 5.1 && apart > 0)
            std::snprintf(outside[2], sizeof outside[2], "← one root at −%.3g", left);
        else if (left > 5.1 || up > 3.1)
            std::snprintf(outside[2], sizeof outside[2], "roots at −%.3g ± %.3g i", left, up);
        for (Run& run : runs) {
            say(run, verdict(s, run.limit(zeta.value)), spring.omega / run.limit(zeta.value));
            run.now = {0, 1, 0}, run.off = 0;  // let go at rest, a metre from its place
        }
        // We show six periods, or 60 steps; of many short steps only some.
        const double period = 2 * 3.14159265358979 / s, steps_shown = std::fmax(60, 6 * period);  // in steps
        stride = static_cast<int>(std::ceil(steps_shown / most_samples));
        shown = std::min(most_samples, static_cast<std::size_t>(steps_shown));
        // The true motion goes on between the steps. Where it swings too fast to be drawn we fill
        // what it sweeps.
        finer = static_cast<int>(2 * most_samples / shown);
        omega_damped = zeta.value < 1 ? spring.omega * std::sqrt(1 - zeta.value * zeta.value) : 0;
        swings = omega_damped * h / (2 * 3.14159265358979);
        // As advise does, we compare the first period with the truth (beyond ζ = 1 that of the slow
        // decay), and where fewer than three steps fit into it, eight steps.
        const double slow = zeta.value < 1 ? 1 : 1 / (zeta.value + std::sqrt(zeta.value * zeta.value - 1));
        compared = period / slow < 3 ? 8 : static_cast<long>(period / slow);
        // The exact motion without a sine: Runge-Kutta 4 with a millionth of the step, doubled
        // twenty times.
        exact_step = step_matrix(runge_kutta_4, spring, h / finer / (1 << 20));
        for (int i = 0; i < 20; ++i) exact_step = twice(exact_step);
        exact = {0, 1, 0}, taken = 0, sampled = 0, exact_sampled = 0;
        record_exact(), record();
    }
    double seconds() const override { return 4.0 / static_cast<double>(shown); }

    void step() override {
        for (int i = 0; i < stride; ++i) one_step();
        record();
    }
    void draw(live::Picture& p) const override {
        draw_map(p), draw_runs(p);
        if (!p.narrow) draw_plane(p);
    }
    // The dot on the map: sideways it sets the damper, upwards the rate.
    bool grab(double x, double y) override { return std::fabs(x - dot_x()) < 0.2 && std::fabs(y - dot_y()) < 0.5; }
    void drag(double x, double y) override {
        set(c, 2 * std::clamp(x, 0.0, 2.0) * std::sqrt(k * m));
        set(rate, spring().omega / std::clamp(y, 0.05, 5.0));
    }
    bool handle(double& x, double& y) const override { return x = dot_x(), y = dot_y(), true; }

private:
    DampedSpring<double> spring() const { return DampedSpring<double>::from_stiffness(k, c, m); }
    double dot_x() const { return std::fmin(zeta.value, 2); }
    double dot_y() const { return std::fmin(s, 5); }

    // The verdict, and the rate at which it changes: short, for a phone.
    static void say(Run& run, Verdict verdict, double at) {
        const char* where = verdict == Verdict::stable ? "≥" : verdict == Verdict::grows ? "<" : "at";
        const char* form = !std::isfinite(at) || at == 0 ? "%s at every rate"
                           : at < 1000                   ? "%s %s %.4g Hz"
                                                         : "%s %s %.4g kHz";
        std::snprintf(run.verdict, sizeof run.verdict, form, words(verdict), where, at < 1000 ? at : at / 1000);
    }
    void one_step() {
        const auto step_one = [this, damped = spring()](const auto& method, Run& run) {
            if (!run.holds) return;
            const State<double> last = run.now;
            if constexpr (requires { method.step(damped, last, h); })
                run.now = method.step(damped, last, h);
            else
                run.now = taken == 1 ? method.start(damped, last, h) : method.step(damped, run.before, last, h);
            run.before = last;
            if (taken <= compared) run.off = std::fmax(run.off.value, 100 * std::fabs(run.now.x - exact.x));
            if (!run.holds.holds(std::fabs(run.now.x) < 1e6)) run.holds.blown_at = taken;
        };
        ++taken;
        for (int i = 0; i < finer; ++i) {
            exact = {0, exact_step.xx * exact.x + exact_step.xv * exact.v,
                     exact_step.vx * exact.x + exact_step.vv * exact.v};
            if (stride == 1 || (i + 1 == finer && taken % stride == 0)) record_exact();
        }
        std::size_t i = 0;
        std::apply([&](const auto&... method) { (step_one(method, runs[i++]), ...); }, methods);
    }
    // The place; where it cannot be followed, how far the swing goes to both sides.
    void record_exact() {
        const double u = too_fast() ? (exact.v + zeta.value * s / h * exact.x) / omega_damped : 0;
        exact_samples[exact_sampled++ % most_exact] = too_fast() ? std::sqrt(exact.x * exact.x + u * u) : exact.x;
    }
    bool too_fast() const { return swings.value > finer / 8.0; }  // eight of its places a swing make a curve
    void record() {
        ++sampled;
        for (Run& run : runs)
            if (run.holds) run.samples[(sampled - 1) % most_samples] = run.now.x, run.end = sampled;
    }

    // The runs, one below the other, in front of the exact motion.
    void draw_runs(live::Picture& p) const {
        const double width = static_cast<double>(shown);
        p.window(0, width, -4.0 * static_cast<double>(runs.size()), 0.8, false, 0, p.narrow ? 1 : 0.58,
                 p.narrow ? 0.4 : 0, 1);
        double middle = -2.5;
        for (const Run& run : runs) {
            p.ink("soft", 1), p.segment(0, middle, width, middle);
            // A run that grows shrinks its row, to a tenth at most. Farther out it is gone.
            const double room =
                p.narrow ? 0.8 : 1.2;  // for a metre, in rows of four; on a phone the letters take more of it
            double largest = 1.2;
            const std::size_t from = sampled > shown ? sampled - shown : 0;
            std::size_t end = from;
            for (; end < run.end && std::fabs(run.samples[end % most_samples]) < 12; ++end)
                largest = std::fmax(largest, std::fabs(run.samples[end % most_samples]));
            const double scale = room / (end < run.end || !run.holds ? 12 : largest);
            draw_exact(p, middle, scale);
            p.ink(run.name, 1.5), draw_run(p, run.samples, from, end, middle, scale);
            if (end < run.end || !run.holds) p.text(0.79 * width, middle + 1.5, "past 12 m");
            p.text(0, middle + 1.5, run.name == semi_implicit_euler_new_damping.name ? "new damping" : run.name);
            p.ink("ink"), p.text(0.41 * width, middle + 1.5, run.verdict);
            middle -= 4;
        }
    }
    void draw_exact(live::Picture& p, double middle, double scale) const {
        const int places = stride > 1 ? 1 : finer;  // from one step that is drawn to the next
        const std::size_t from = (sampled > shown ? sampled - shown : 0) * static_cast<std::size_t>(places);
        const auto to = [&](std::size_t n, double side) {
            const double x = static_cast<double>(n - from) / places,
                         y = middle + side * scale * exact_samples[n % most_exact];
            n == from&& side > 0 ? p.move(x, y) : p.line(x, y);
        };
        p.ink("exact", 4, 0.5);
        for (std::size_t n = from; n < exact_sampled; ++n) to(n, 1);
        if (!too_fast()) return p.stroke();
        for (std::size_t n = exact_sampled; n > from; --n) to(n - 1, -1);
        p.fill();
    }
    static void draw_run(live::Picture& p, const double (&positions)[most_samples], std::size_t from, std::size_t end,
                         double middle, double scale) {
        for (std::size_t n = from; n < end; ++n) {
            const double x = static_cast<double>(n - from), y = middle + scale * positions[n % most_samples];
            n == from ? p.move(x, y) : p.line(x, y);
        }
        if (end > from) p.stroke();
    }

    // Each method's longest stable step, against the damping.
    void draw_map(live::Picture& p) const {
        p.window(-0.06, 2.06, -0.15, 5.15, false, p.narrow ? 0 : 0.58, 1, p.narrow ? 0 : 0.45, p.narrow ? 0.4 : 1);
        p.axes("damping ratio ζ", "longest step, ωh");
        for (const Run& run : runs) {
            if (!run.has_limit()) continue;
            p.ink(run.name, 2);
            p.move(0, run.drawn_limit(0));
            for (int n = 1; n <= 80; ++n) p.line(n / 40.0, run.drawn_limit(n / 40.0));
            p.stroke();
        }
        p.ink("ink"), p.dot(dot_x(), dot_y(), 7);
        if (zeta.value > 2) p.text(1.3, std::fmin(dot_y() + 0.3, 3.5), outside[0]);
        if (s > 5) p.text(std::fmin(dot_x() + 0.08, 1.3), 4.3, outside[1]);
    }

    // The plane of z = hλ. In the direction of each ζ a stability region ends where |z| = ωh is the
    // limit.
    void draw_plane(live::Picture& p) const {
        p.window(-5.2, 1.4, -3.2, 3.2, true, 0.58, 1, 0, 0.45);
        p.axes("real part of hλ", "imaginary part");
        for (const Run& run : runs) {
            if (!run.has_limit()) continue;
            p.ink(run.name, 2);
            for (const double side : {-1, 1}) {
                for (int n = 0; n <= 40; ++n) {
                    const double up = n / 40.0, x = up * up - 1, limit = run.drawn_limit(-x);
                    const double y = side * limit * std::sqrt(1 - x * x);
                    n == 0 ? p.move(limit * x, y) : p.line(limit * x, y);
                }
                p.stroke();
            }
        }
        p.ink("ink");
        const double inside = 1 - zeta.value * zeta.value, root = s * std::sqrt(std::fabs(inside));
        for (const double apart : {-root, root})
            p.dot(std::fmax(-zeta.value * s + (inside < 0 ? apart : 0), -5.1),
                  std::clamp(inside < 0 ? 0 : apart, -3.1, 3.1), 6);
        if (outside[2][0]) p.text(-5, 0.3, outside[2]);
    }

    live::LogSlider k{this, "k", "stiffness k", 10, 1e6, 10000, "N/m"};
    live::LogSlider m{this, "m", "mass m", 0.05, 100, 1, "kg"};
    live::Slider c{this, "c", "damper c", 0, 1000, 0.5, 10, "N s/m"};
    live::LogSlider rate{this, "rate", "steps a second", 10, 1000, 60, "Hz"};
    live::Readout omega_h{this, "ωh"};
    live::Readout zeta{this, "ζ"};
    live::Readout swings{this, "true swings", "a step"};
    std::array<Run, std::tuple_size_v<decltype(methods)>> runs =
        std::apply([this](const auto&... method) { return std::array{Run(this, method)...}; }, methods);

    double h = 0, s = 0, omega_damped = 0;  // the last: of the true motion, rad/s
    int stride = 1;                         // steps from one sample to the next
    int finer = 20;                         // places of the true motion in a step
    long taken = 0, compared = 0;
    std::size_t shown = 60, sampled = 0, exact_sampled = 0;
    char outside[3][64] = {};  // what lies beyond the edges of map and plane
    StepMatrix<double> exact_step{};
    State<double> exact{};
    double exact_samples[most_exact]{};
};
LIVE_PANEL(BlowUp)
