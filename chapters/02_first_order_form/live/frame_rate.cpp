// A character on springy legs is pulled and let go, in two games: in one each frame is one step, in
// the other an accumulator pays the frames in steps of one length. Four seconds are computed at
// once, and then played. still: steps=190

#include <algorithm>
#include <array>
#include <cmath>

#include <timestep/game_loop.hpp>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/scene.hpp>

#include "live.hpp"

using namespace timestep;

class FrameRate : public live::Panel {
public:
    FrameRate() {
        title = "A character on a spring, stepped by the frame's time and by a fixed time step";
        aspect = 0.62, aspect_narrow = 1.3;
    }

    void restart() override {
        clock = 0, shown = 0;
        follow_exactly();
        play();
    }
    double seconds() const override { return 1.0 / 120; }

    // The reader's clock goes on, and the screen keeps the last frame that was drawn. Then once
    // more.
    void step() override {
        if (held) return;
        clock += seconds();
        if (clock > length + 1) clock = 0, shown = 0;
        while (shown + 1 < count && frames[shown + 1].time <= clock) ++shown;
    }

    void draw(live::Picture& p) const override {
        const double side = p.narrow ? 1.2 : 0.45;
        p.window(-2 * side, 2 * side, -0.1, 2.8, true, 0, p.narrow ? 1 : 0.36, p.narrow ? 0.58 : 0, 1);
        p.ink("ink", 2);
        p.segment(-4, 0, 4, 0);
        draw_character(p, -side, "variable step", variable_name, frames[shown].variable);
        draw_character(p, side, "fixed step", fixed_name, frames[shown].fixed);

        p.window(0, length, -0.2, 2.2, false, p.narrow ? 0 : 0.36, 1, 0, p.narrow ? 0.58 : 1);
        p.axes("time, s", "height of the hip, m");
        p.ink("exact", 5, 0.6);
        for (std::size_t i = 0; i + 1 < exact.size(); ++i)
            i == 0 ? p.move(0, 1 + exact[0].x) : p.line(gap * static_cast<double>(i), 1 + exact[i].x);
        p.stroke();
        draw_trace(p, variable_name, &Frame::variable);
        draw_trace(p, fixed_name, &Frame::fixed);
    }

    // The character can be pulled at, and stays in the hand until it is let go.
    bool grab(double x, double height) override { return held = std::fabs(x) < 2 && height > 0.3 && height < 2.3; }
    void drag(double, double height) override { set(start, height - 1); }
    void let_go() override { held = false; }
    bool handle(double& x, double& height) const override { return x = 0, height = 1 + start, true; }

private:
    using Character = State<double>;
    struct Frame {
        double time, variable, fixed;  // s, and the two x as they are drawn, m
    };
    static constexpr const char* variable_name = "variable time step";
    static constexpr const char* fixed_name = "fixed time step";
    static constexpr double length = 4;                             // s
    static constexpr double gap = 0.02;                             // s, between two known states of the true motion
    static constexpr double too_far = 10;                           // m: whoever has gone so far has blown up
    static constexpr double omega = 8, zeta = 0.1, gravity = 9.81;  // the chapter's character

    template <class Method>
    static Character step(const Method& by, const Character& state, double h) {
        return by.step(Scene{DampedSpring{omega, zeta}, Projectile{-gravity}}, state, h);
    }
    Character step(const Character& state, double h) const {
        return method == 0   ? step(explicit_euler, state, h)
               : method == 1 ? step(semi_implicit_euler, state, h)
                             : step(runge_kutta_4, state, h);
    }

    // Both games, frame by frame.
    void play() {
        Character variable{0, start, 0}, before = variable, now = variable;
        GameLoop loop(1 / fixed_rate, 1000);
        variable_far = 0, fixed_far = 0;
        double time = 0;
        for (count = 0; count < frames.size() && time <= length; ++count) {
            frames[count] = {time, variable.x, (interpolated ? interpolate(before, now, loop.alpha()) : now).x};
            double passed = 1 / rate;
            if (std::floor(time + 0.5 + passed) > std::floor(time + 0.5)) passed += hitch / 1000;  // once a second
            time += passed;

            if (variable_holds) variable = step(variable, passed);
            look(variable, variable_holds, static_cast<long>(count) + 1, variable_far);
            loop.frame(passed, [&](double h) {
                before = now;
                if (fixed_holds) now = step(now, h);
                look(now, fixed_holds, loop.steps() + 1, fixed_far);
            });
        }
    }

    // Has it blown up, at the step of its own with this number? And how far from the true motion
    // has it been at most?
    void look(const Character& state, live::Fuse& holds, long number, live::Readout& far) const {
        if (holds && std::fabs(state.x) > too_far) holds.blown_at = number;
        if (state.t <= length) far = std::max(far.value, std::fabs(state.x - true_place(state.t)));
    }
    double true_place(double t) const {
        const Character& near = exact[static_cast<std::size_t>(t / gap)];
        return step(runge_kutta_4, near, t - near.t).x;
    }

    // The formula has exp and sin, whose last bits are another in each browser; tiny steps of RK4
    // are as good here.
    void follow_exactly() {
        Character state{0, start, 0};
        for (std::size_t i = 0; i < exact.size(); ++i) {
            state.t = gap * static_cast<double>(i);
            exact[i] = state;
            for (int n = 0; n < 20; ++n) state = step(runge_kutta_4, state, gap / 20);
        }
    }

    static void draw_character(live::Picture& p, double x, const char* words, const char* look, double height) {
        p.ink(look, 2);
        p.text(x - 0.35, 2.6, words);
        if (std::fabs(height) > too_far) return;
        const double hip = 1 + height;
        p.move(x, 0);
        for (int i = 1; i < 10; ++i) p.line(x + (i % 2 == 0 ? 0.12 : -0.12), hip * i / 10);
        p.line(x, hip);
        p.stroke();
        p.ink(look, 14);
        p.segment(x, hip + 0.05, x, hip + 0.6);
        p.dot(x, hip + 0.85, 11);
    }

    // A dot a frame, while they can be told apart; a large one for the frame on the screen.
    void draw_trace(live::Picture& p, const char* look, double Frame::*x) const {
        p.ink(look, 1.5, 0.7);
        for (std::size_t i = 0; i < count && std::fabs(frames[i].*x) <= too_far; ++i)
            i == 0 ? p.move(0, 1 + frames[i].*x) : p.line(frames[i].time, 1 + frames[i].*x);
        p.stroke();
        for (std::size_t i = 0; i < count && std::fabs(frames[i].*x) <= too_far; ++i)
            if (i == shown || rate < 100) p.dot(frames[i].time, 1 + frames[i].*x, i == shown ? 7 : 2.5);
    }

    live::Slider rate{this, "rate", "frame rate", 10, 240, 1, 30, "Hz"};
    live::Slider hitch{this, "hitch", "hitch each second", 0, 250, 5, 0, "ms"};
    live::Slider fixed_rate{this, "fixed", "fixed step rate", 20, 240, 1, 60, "Hz"};
    live::Toggle interpolated{this, "interpolated", "interpolate", true};
    live::Choice method{this, "method", "method", "explicit Euler|semi-implicit Euler|Runge-Kutta 4"};
    live::Slider start{this, "start", "let go at", -0.5, 0.5, 0.01, -0.45, "m"};
    // How far from the true motion each has been at most.
    live::Readout variable_far{this, variable_name, "m off"}, fixed_far{this, fixed_name, "m off"};
    live::Fuse variable_holds{this, variable_name}, fixed_holds{this, fixed_name};

    std::array<Frame, 1000> frames{};
    std::array<Character, 202> exact{};
    std::size_t count = 0, shown = 0;  // frames
    double clock = 0;                  // s
    bool held = false;
};
LIVE_PANEL(FrameRate)
