// One spring in the phase portrait, stepped by the three Eulers. Pull at the dot, and at ωh.
// still: omega_h=0.17 steps=37

#include <array>
#include <cmath>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>

#include "live.hpp"

using namespace timestep;

double length(double x, double y) {
    return std::sqrt(x * x + y * y);  // hypot has other bits elsewhere
}

// One method's run: a state, where it has been, and the corners of a cloud of states around it.
struct Run {
    Run(live::Panel* panel, const char* name) : name(name), number{panel, name}, holds{panel, name} {}

    void begin(const State<double>& start) {
        state = start;
        trail.clear();
        double c = 0.3, s = 0;
        for (State<double>& corner : cloud) {
            corner = {0, start.x + c, start.v + s};
            const double turned = 0.96592582628906831 * c - 0.25881904510252074 * s;  // by a 24th of a turn
            s = 0.25881904510252074 * c + 0.96592582628906831 * s, c = turned;
        }
    }
    template <class Method>
    void step(const Method& method, double h) {
        if (!holds) return;
        const Spring spring(1.0);  // ω = 1 rad/s: so ωh is h, and v/ω is v
        state = method.step(spring, state, h);
        for (State<double>& corner : cloud) corner = method.step(spring, corner, h);
        holds.holds(amplitude() < 1e6);
    }
    double amplitude() const { return length(state.x, state.v); }
    double area() const {
        double twice = 0;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            const State<double>&a = cloud[i], &b = cloud[(i + 1) % cloud.size()];
            twice += (a.x - state.x) * (b.v - state.v) - (a.v - state.v) * (b.x - state.x);
        }
        return twice / 2;
    }

    const char* name;
    live::Readout number;
    live::Fuse holds;
    State<double> state{};
    std::array<State<double>, 24> cloud{};
    live::Trail<400> trail;
};

class ThreeEulers : public live::Panel {
public:
    ThreeEulers() {
        title = "Three Eulers on one spring";
        aspect = 0.8, aspect_narrow = 1;
    }

    void restart() override {
        for (Run& run : runs) run.begin({0, x, v});
        area_at_start = runs[0].area();
        record();
    }
    double seconds() const override { return 1.0 / 20; }

    void step() override {
        runs[0].step(explicit_euler, h);
        runs[1].step(implicit_euler, h);
        runs[2].step(semi_implicit_euler, h);
        record();
    }

    void draw(live::Picture& p) const override {
        p.window(-3, 3, -2.4, 2.4, true);
        p.axes("x, m", "v/ω, m");
        p.ink("exact", 5, 0.6);
        p.circle(0, 0, length(x, v));
        p.stroke();
        for (const int i : {1, 2, 0}) draw(p, runs[i]);
        if (runs[0].amplitude() > 4) p.text(-2.9, 2.1, "explicit Euler has left the picture");
        p.ink(semi_implicit_euler.name);
        if (h >= 2 && runs[2].amplitude() > 40)
            p.text(-2.9, 1.7,
                   h > 2 ? "semi-implicit Euler has left the picture" : "semi-implicit Euler grows, at its limit");
        p.ink("ink", 2);
        p.dot(x, v, 4);
    }

    // The start can be dragged.
    bool grab(double at_x, double at_v) override { return length(at_x - x, at_v - v) < 0.5; }
    void drag(double to_x, double to_v) override {
        set(x, to_x);
        set(v, to_v);
    }
    bool handle(double& at_x, double& at_v) const override { return at_x = x, at_v = v, true; }

private:
    void record() {
        for (Run& run : runs) {
            if (run.holds) run.trail.add(run.state.x, run.state.v);
            run.number = cloud ? run.area() / area_at_start : run.amplitude();
            run.number.unit = cloud ? "× as large" : "m";
        }
    }
    void draw(live::Picture& p, const Run& run) const {
        if (cloud) {
            p.ink(run.name, 2, 0.5);
            for (const State<double>& corner : run.cloud)
                &corner == run.cloud.data() ? p.move(corner.x, corner.v) : p.line(corner.x, corner.v);
            p.fill();
        }
        p.ink(run.name, 2);
        run.trail.draw(p);
        p.dot(run.state.x, run.state.v);
    }

    live::Slider h{this, "omega_h", "ωh", 0.01, 2.2, 0.01, 0.17, "rad"};
    live::Slider x{this, "x", "start x", -2, 2, 0.01, 1, "m"};
    live::Slider v{this, "v", "start v/ω", -2, 2, 0.01, 0, "m"};
    live::Toggle cloud{this, "cloud", "a cloud of states"};
    // Under the names of the methods: how far each is from the centre, or how large its cloud is.
    std::array<Run, 3> runs{Run(this, explicit_euler.name), Run(this, implicit_euler.name),
                            Run(this, semi_implicit_euler.name)};
    double area_at_start = 1;
};
LIVE_PANEL(ThreeEulers)
