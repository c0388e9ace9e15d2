// A rope of points without velocities: grab it anywhere and throw it about.
// still: sweeps=2 steps=48

#include <array>

#include <Eigen/Core>

#include <timestep/linear_solve.hpp>
#include <timestep/methods/verlet.hpp>
#include <timestep/models/projectile.hpp>

#include "live.hpp"

using namespace timestep;
using Eigen::Vector2d;

class RopePanel : public live::Panel {
public:
    RopePanel() {
        title = "A rope by Verlet";
        aspect = 0.8, aspect_narrow = 0.9;
    }

    void restart() override {
        hook = finger = Vector2d(0, 0), grabbed = -1;
        for (auto* rope : {&plain, &corrected})
            for (int i = 0; i <= links; ++i)
                rope->before[i] = rope->now[i] = {0, Vector2d(i * link, 0), Vector2d(0, 0)};
        chance = 1;
        dt_before = 1.0 / 60 / cuts;
        plain_too_long = 0, corrected_too_long = 0;
        dt_now = 1000 * dt_before, iterations = cuts * sweeps;
    }
    // The iterations act on the moving rope. Another step would kick it, as the reader is to see by
    // Δt alone.
    bool restarts(const live::Control& c) const override { return &c != &sweeps || steps == 0; }

    // A frame of the page: steps of equal length, but not as many as in the frame before where Δt
    // changes.
    void step() override {
        const int n = steps_a_frame();
        const double dt = 1.0 / 60 / n;
        for (int i = 0; i < n; ++i) {
            if (plain_holds) move(plain, dt, n, false);
            if (corrected_holds) move(corrected, dt, n, true);
            dt_before = dt;
        }
        plain_holds.holds(stretch(plain) < 100);
        corrected_holds.holds(stretch(corrected) < 100);
        iterations = n * sweeps, dt_now = 1000 * dt;
        // Averaged over a third of a second, so that it can be read.
        plain_too_long = plain_too_long.value + (100 * stretch(plain) - plain_too_long.value) / 20;
        corrected_too_long = corrected_too_long.value + (100 * stretch(corrected) - corrected_too_long.value) / 20;
    }

    void draw(live::Picture& p) const override {
        p.window(-2.4, 2.4, lowest, 1.3, true);
        p.ink("faint", 1.5);  // a rope of the right length cannot leave this circle
        double x = links * link, y = 0;
        p.move(hook(0) + x, hook(1));
        for (int degrees = 3; degrees <= 360; degrees += 3) {
            const double c = 0.99862953475457387, s = 0.052335956242943835, turned = c * x - s * y;
            y = s * x + c * y, x = turned;
            p.line(hook(0) + x, hook(1) + y);
        }
        p.stroke();
        if (corrected_holds) draw(p, "first", corrected, 4);
        if (plain_holds) draw(p, verlet.name, plain, 3);
        p.ink("ink");
        p.dot(hook(0), hook(1), 5);
        if (grabbed > 0) p.dot(finger(0), finger(1), 4);
        if (grabbed <= 0 &&
            std::fmax(plain_too_long.value, corrected_too_long.value) > 5)  // else it may be the finger's doing
            p.text(-2.3, -3.2, "too long: too few iterations or steps");
    }

    // The finger takes the nearest point of either rope, and holds that point of both.
    bool grab(double x, double y) override {
        double nearest = 0.35;
        grabbed = -1;
        for (const auto* rope : {&plain, &corrected})
            for (int i = 0; i <= links; ++i) {
                const double far = (rope->now[i].x - Vector2d(x, y)).norm();
                if (far < nearest) nearest = far, grabbed = i;
            }
        if (grabbed >= 0) drag(x, y);
        return grabbed >= 0;
    }
    void drag(double x, double y) override {
        const auto within = [](double a, double least, double most) { return a < least ? least : a > most ? most : a; };
        finger = Vector2d(within(x, -2.4, 2.4), within(y, lowest, 1.3));
        if (grabbed == 0) hook = finger;
    }
    void let_go() override { grabbed = -1; }
    bool handle(double& x, double& y) const override { return x = hook(0), y = hook(1), true; }

private:
    static constexpr int links = 20;
    static constexpr double link = 0.1;     // m
    static constexpr double lowest = -3.3;  // of the picture, m
    struct Rope {
        std::array<State<Vector2d>, links + 1> before, now;
    };

    // Verlet for each point as if it were alone, then some iterations over the links.
    void move(Rope& rope, double dt, int n, bool corrects) {
        const Projectile<Vector2d> gravity(Vector2d(0, -9.81));
        for (int i = 0; i <= links; ++i) {
            State<Vector2d>&before = rope.before[i], &now = rope.now[i];
            State<Vector2d> next = corrects ? verlet.corrected_step(gravity, before, now, dt_before, dt)
                                            : verlet.step(gravity, before, now, dt);
            // What is held goes a third of the way to the finger in a frame: so it has a speed when
            // it is let go.
            if (held(i)) next.x = now.x + ((i == 0 ? hook : finger) - now.x) / (1 + 2 * n);
            before = now, now = next;
        }
        for (int k = 0; k < sweeps; ++k)
            for (int i = 1; i <= links; ++i) put_right(rope, i);
    }
    // The ends of a link share what is too long or too short, as in rope.hpp, which holds the first
    // point only.
    void put_right(Rope& rope, int i) const {
        Vector2d &a = rope.now[i - 1].x, &b = rope.now[i].x;
        const Vector2d excess = b - a - link * direction(Vector2d(b - a));
        const bool a_moves = !held(i - 1), b_moves = !held(i);
        if (a_moves) a += excess / (1 + b_moves);
        if (b_moves) b -= excess / (1 + a_moves);
    }
    bool held(int i) const { return i == 0 || i == grabbed; }

    // How many steps this frame is cut into.
    int steps_a_frame() {
        const int n = static_cast<int>(cuts);
        if (changes == 1) return steps / 30 % 2 == 0 ? n : 4 * n;
        if (changes == 2) return n * static_cast<int>(1 + (chance = chance * 1103515245 + 12345) / 65536 % 4);
        return n;
    }
    // The rope's length over what it should be, less one.
    static double stretch(const Rope& rope) {
        double length = 0;
        for (int i = 1; i <= links; ++i) length += (rope.now[i].x - rope.now[i - 1].x).norm();
        return length / (links * link) - 1;
    }
    static void draw(live::Picture& p, const char* look, const Rope& rope, double width) {
        p.ink(look, width);
        p.move(rope.now[0].x(0), rope.now[0].x(1));
        for (int i = 1; i <= links; ++i) p.line(rope.now[i].x(0), rope.now[i].x(1));
        p.stroke();
        for (int i = 1; i <= links; ++i) p.dot(rope.now[i].x(0), rope.now[i].x(1), width);
    }

    live::Slider sweeps{this, "sweeps", "iterations a step", 1, 64, 1, 2};
    live::Slider cuts{this, "cuts", "steps a frame", 1, 8, 1, 1};
    live::Choice changes{this, "changes", "Δt", "stays the same|shorter every other half second|changes every frame"};
    live::Readout plain_too_long{this, verlet.name, "% over 2 m"};
    live::Readout corrected_too_long{this, "corrected for Δt", "% over 2 m", "first"};
    live::Readout dt_now{this, "Δt", "ms"};
    live::Readout iterations{this, "iterations a frame"};
    live::Fuse plain_holds{this, verlet.name};
    live::Fuse corrected_holds{this, "corrected Verlet"};

    Rope plain, corrected;
    Vector2d hook, finger;
    int grabbed = -1;  // the point that is held by the finger, or -1
    double dt_before = 0;
    unsigned chance = 1;
};
LIVE_PANEL(RopePanel)
