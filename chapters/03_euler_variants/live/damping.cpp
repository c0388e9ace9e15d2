// A damped spring, its damper at the old velocity and at the new one; and where on the map of
// stable steps it is. still: steps=40

#include <array>
#include <cmath>

#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/stability_limit.hpp>

#include "live.hpp"

using namespace timestep;

class Damping : public live::Panel {
public:
    Damping() {
        title = "Damping: does it help?";
        aspect = 0.7, aspect_narrow = 1.7;
    }

    void restart() override {
        old_run.begin(), new_run.begin(), true_run.begin();
        old_limit = limit(semi_implicit_euler, zeta);
        new_limit = limit(semi_implicit_euler_new_damping, zeta);
    }
    double seconds() const override { return 1.0 / 20; }

    // ω = 1 rad/s, so that ωh is h. When the picture is full the run stands, until something is
    // changed.
    void step() override {
        if (steps > shown) return;
        const DampedSpring spring(1.0, zeta.value);
        const auto alive = [](const Run& run) { return std::fabs(run.state.x) < 1e6 && std::fabs(run.state.v) < 1e6; };
        if (old_holds) old_run.add(semi_implicit_euler.step(spring, old_run.state, h));
        if (new_holds) new_run.add(semi_implicit_euler_new_damping.step(spring, new_run.state, h));
        for (int i = 0; i < finer; ++i) true_run.add(runge_kutta_4.step(spring, true_run.state, h / finer));
        old_holds.holds(alive(old_run));
        new_holds.holds(alive(new_run));
    }

    void draw(live::Picture& p) const override {
        // The map comes first: there the finger moves the dot.
        p.narrow ? part(p, -0.06, 2.06, -0.2, 5.2, 0, 1, 0.58, 1) : part(p, -0.06, 2.06, -0.2, 5.2, 0, 0.45, 0, 1);
        p.axes("damping ratio ζ", "ωh, rad");
        limits(p, semi_implicit_euler);
        limits(p, semi_implicit_euler_new_damping);
        p.text(0.95, 1.3, "old velocity");
        p.text(0.95, 3.9, "new velocity");
        p.ink("ink");
        p.dot(zeta, h, 6);

        p.narrow ? part(p, 0, shown + 1, -2, 2, 0, 1, 0.29, 0.58) : part(p, 0, shown + 1, -2, 2, 0.47, 1, 0.5, 1);
        p.axes("steps", "x, m, damper at the new velocity");
        draw(p, semi_implicit_euler_new_damping.name, new_holds, new_run);
        p.narrow ? part(p, 0, shown + 1, -2, 2, 0, 1, 0, 0.29) : part(p, 0, shown + 1, -2, 2, 0.47, 1, 0, 0.5);
        p.axes("steps", "x, m, damper at the old velocity");
        draw(p, semi_implicit_euler.name, old_holds, old_run);
    }

    bool grab(double to_zeta, double to_h) override {
        if (to_zeta < -0.1 || to_zeta > 2.1 || to_h < -0.3 || to_h > 5.3) return false;  // not on the map
        drag(to_zeta, to_h);
        return true;
    }
    void drag(double to_zeta, double to_h) override {
        set(zeta, to_zeta);
        set(h, to_h);
    }
    bool handle(double& at_zeta, double& at_h) const override { return at_zeta = zeta, at_h = h, true; }

private:
    static constexpr int shown = 40;   // steps
    static constexpr double gone = 6;  // m: three times what the diagrams show
    static constexpr int finer = 20;   // steps of RK4 in one of ours: no eye tells them from the true motion

    // What the spring has done, let go at one metre.
    struct Run {
        State<double> state;
        std::array<double, shown * finer + 1> x;
        int size;
        void begin() { state = {0, 1, 0}, x[0] = 1, size = 1; }
        void add(const State<double>& next) {
            state = next;
            if (size < static_cast<int>(x.size())) x[size++] = next.x;
        }
    };
    static void part(live::Picture& p, double left, double right, double bottom, double top, double from_x, double to_x,
                     double from_y, double to_y) {
        p.window(left, right, bottom, top, false, from_x, to_x, from_y, to_y);
    }
    // The true motion, and a method on it: its steps are the dots.
    void draw(live::Picture& p, const char* look, bool holds, const Run& run) const {
        p.ink("exact", 4);
        line(p, true_run, 1.0 / finer, true_run.size);
        int drawn = 0;  // steps, until it is gone
        while (drawn < run.size && std::fabs(run.x[drawn]) < gone) ++drawn;
        p.ink(look, 1.5, 0.6);
        line(p, run, 1, drawn);
        p.ink(look);
        for (int i = 0; i < drawn && i <= shown; ++i) p.dot(i, run.x[i], 3);
        if (drawn < run.size || !holds) p.text(drawn < 15 ? drawn + 1 : 15, -1.6, "grows out of the picture");
    }
    static void line(live::Picture& p, const Run& run, double step, int size) {
        p.move(0, run.x[0]);
        for (int i = 1; i < size; ++i) p.line(i * step, run.x[i]);
        p.stroke();
    }
    // The largest stable ωh. The last bit of its hypot is another one in the page than in the
    // shell: float drops it.
    template <class Method>
    static double limit(const Method& method, double zeta) {
        return static_cast<float>(stability_limit(method, zeta).value);
    }
    // The same against damping: below its line a method is stable.
    template <class Method>
    static void limits(live::Picture& p, const Method& method) {
        p.ink(method.name, 3);
        for (int i = 0; i <= 40; ++i) {
            const double y = limit(method, i / 20.0);
            i == 0 ? p.move(0, y) : p.line(i / 20.0, y);
        }
        p.stroke();
    }

    live::Slider zeta{this, "zeta", "damping ratio ζ", 0, 2, 0.01, 0.4};
    live::Slider h{this, "omega_h", "ωh", 0.05, 5, 0.01, 1.4, "rad"};
    live::Readout old_limit{this, "old velocity", "rad, limit of ωh", semi_implicit_euler.name};
    live::Readout new_limit{this, "new velocity", "rad, limit of ωh", semi_implicit_euler_new_damping.name};
    live::Fuse old_holds{this, "the damper at the old velocity"};
    live::Fuse new_holds{this, "the damper at the new velocity"};

    Run old_run, new_run, true_run;
};
LIVE_PANEL(Damping)
