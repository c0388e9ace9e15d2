// A falling ball, step by step, beside the exact one. FILL IN: your own scene; tools/live/README.md says how.
// still: steps=20

#include <timestep/methods/explicit_euler.hpp>
#include <timestep/models/projectile.hpp>

#include "live.hpp"

using namespace timestep;

class FallingBall : public live::Panel {
public:
    FallingBall() { title = "A ball that falls, in steps"; }

    void restart() override { state = {0, 0.0, 0.0}; }  // t, x, v: at rest
    double seconds() const override { return h; }

    void step() override {
        if (state.t > 1.5) restart();
        state = explicit_euler.step(ball, state, h);
        stepped = state.x, exact = ball.exact(State{0, 0.0, 0.0}, state.t).x;
    }

    void draw(live::Picture& p) const override {
        p.window(-1, 1, -12, 1);
        p.axes("", "height, m");
        p.ink("exact");
        p.dot(0.2, exact.value, 9);
        p.ink(explicit_euler.name);
        p.dot(-0.2, stepped.value, 9);
    }

private:
    const Projectile<double> ball{-9.81};  // m/s²
    live::Slider h{this, "h", "step", 0.01, 0.5, 0.01, 0.1, "s"};
    live::Readout stepped{this, explicit_euler.name, "m"}, exact{this, "exact", "m"};
    State<double> state{};
};
LIVE_PANEL(FallingBall)
