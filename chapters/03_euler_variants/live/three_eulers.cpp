// One spring in the phase portrait, stepped by the three Eulers. Pull at the dot, and at ωh.
// still: omega_h=0.17 steps=37

#include <cmath>

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>

#include "live.hpp"

using namespace timestep;

class ThreeEulers : public live::Panel {
public:
    ThreeEulers() {
        title = "Three Eulers on one spring";
        aspect = 0.8, aspect_narrow = 1;
    }

    void restart() override {
        explicit_state = implicit_state = semi_implicit_state = {0, x, v};  // ω = 1 rad/s: v/ω is v
        for (Trail* trail : {&explicit_trail, &implicit_trail, &semi_implicit_trail}) trail->clear();
        record();
    }
    double seconds() const override { return 1.0 / 20; }

    void step() override {
        const Spring spring(1.0);
        if (explicit_holds) explicit_state = explicit_euler.step(spring, explicit_state, h);
        implicit_state = implicit_euler.step(spring, implicit_state, h);
        if (semi_implicit_holds) semi_implicit_state = semi_implicit_euler.step(spring, semi_implicit_state, h);
        explicit_holds.holds(amplitude(explicit_state) < 1e6);
        semi_implicit_holds.holds(amplitude(semi_implicit_state) < 1e6);
        record();
    }

    void draw(live::Picture& p) const override {
        p.window(-3, 3, -2.4, 2.4, true);
        p.axes("x, m", "v/ω, m");
        p.ink("exact", 5, 0.6);
        p.circle(0, 0, length(x, v));
        p.stroke();
        draw(p, implicit_euler.name, implicit_state, implicit_trail);
        draw(p, semi_implicit_euler.name, semi_implicit_state, semi_implicit_trail);
        draw(p, explicit_euler.name, explicit_state, explicit_trail);
        if (amplitude(explicit_state) > 4) p.text(-2.9, 2.1, "explicit Euler has left the picture");
        p.ink(semi_implicit_euler.name);
        if (h >= 2 && amplitude(semi_implicit_state) > 40)
            p.text(-2.9, 1.7, h > 2 ? "semi-implicit Euler has left the picture" : "semi-implicit Euler grows, at its limit");
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
    using Trail = live::Trail<400>;

    static double length(double x, double y) { return std::sqrt(x * x + y * y); }  // hypot has other bits elsewhere
    static double amplitude(const State<double>& s) { return length(s.x, s.v); }
    void record() {
        if (explicit_holds) explicit_trail.add(explicit_state.x, explicit_state.v);
        implicit_trail.add(implicit_state.x, implicit_state.v);
        semi_implicit_trail.add(semi_implicit_state.x, semi_implicit_state.v);
        explicit_amplitude = amplitude(explicit_state);
        implicit_amplitude = amplitude(implicit_state);
        semi_implicit_amplitude = amplitude(semi_implicit_state);
    }
    static void draw(live::Picture& p, const char* name, const State<double>& s, const Trail& trail) {
        p.ink(name, 2);
        trail.draw(p);
        p.dot(s.x, s.v);
    }

    live::Slider h{this, "omega_h", "ωh", 0.01, 2.2, 0.01, 0.17, "rad"};
    live::Slider x{this, "x", "start x", -2, 2, 0.01, 1, "m"};
    live::Slider v{this, "v", "start v/ω", -2, 2, 0.01, 0, "m"};
    // Under the names of the methods: how far they swing.
    live::Readout explicit_amplitude{this, explicit_euler.name, "m"};
    live::Readout implicit_amplitude{this, implicit_euler.name, "m"};
    live::Readout semi_implicit_amplitude{this, semi_implicit_euler.name, "m"};
    live::Fuse explicit_holds{this, explicit_euler.name};
    live::Fuse semi_implicit_holds{this, semi_implicit_euler.name};

    State<double> explicit_state{}, implicit_state{}, semi_implicit_state{};
    Trail explicit_trail, implicit_trail, semi_implicit_trail;
};
LIVE_PANEL(ThreeEulers)
