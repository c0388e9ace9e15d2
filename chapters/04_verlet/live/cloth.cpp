// A cloth by Verlet: points, links between neighbours, and a finger that pulls until they tear.
// still: steps=150 grab=0.1,-0.35 drag=0.6,-0.5 steps=14

#include <array>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <timestep/linear_solve.hpp>
#include <timestep/methods/verlet.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>

#include "live.hpp"

using namespace timestep;
using Eigen::Vector3d;

class Cloth : public live::Panel {
public:
    Cloth() {
        title = "A cloth by Verlet";
        aspect = 0.8, aspect_narrow = 0.95;
    }

    void restart() override {
        for (int i = 0; i < points; ++i) before[i] = now[i] = {0, start(i), Vector3d(0, 0, 0)};
        whole_across.fill(true), whole_down.fill(true);
        rail = Vector3d(0, 0, 0), grabbed = -1, torn = 0, too_long = 0;
        first_torn.not_yet(), still = 0;
        gust_before = gust = {0, 0.0, 0.0};
        gust.x = 0.03;
    }
    bool restarts(const live::Control&) const override { return steps == 0; }  // else they act on the moving cloth

    void step() override {
        if (still > 0 && grabbed < 0) return void(--still);  // so that what has torn is seen before it flies away
        // Gusts come and go as a spring swings; Verlet steps that, too.
        const State<double> next_gust = verlet.step(Spring(2.0), gust_before, gust, h);
        gust_before = gust, gust = next_gust;

        std::array<State<Vector3d>, points> next;
        for (int i = 0; i < points; ++i) {
            const Projectile<Vector3d> force(Vector3d(0, -gravity, 0) + push_of_wind(i));
            next[i] = verlet.step(force, before[i], now[i], h);
            // What is held follows within some frames: so it has a speed when it is let go.
            if (i == grabbed) next[i].x = now[i].x + (finger - now[i].x) / 3;
            if (hangs(i)) next[i].x = now[i].x + (start(i) + rail - now[i].x) / 3;
            if (next[i].x(1) < floor) next[i].x = {now[i].x(0), floor, now[i].x(2)};  // what is torn off lies there
        }
        before = now, now = next;

        for (int k = 0; k < sweeps; ++k) each_link([&](bool whole, int a, int b) { whole ? put_right(a, b) : void(); });
        const double most = link * (1 + tears_at / 100);
        each_link([&](bool& whole, int a, int b) { whole = whole && length(a, b) < most; });
        read();
    }

    void draw(live::Picture& p) const override {
        p.window(-0.9, 0.9, -1.45, 0.05, true);
        // A cell whose links are whole is a piece of cloth; the more it faces us, the stronger.
        for (int i = 0; i < points - columns; ++i) {
            const int right = i + 1, below = i + columns, opposite = below + 1;
            if (right % columns == 0 || !whole_down[i] || !whole_down[right] || !whole_across[i] ||
                !whole_across[below])
                continue;
            const Vector3d normal = (now[opposite].x - now[i].x).cross(now[right].x - now[below].x);
            p.ink("first", 1, 0.25 + 0.6 * std::fabs(direction(normal)(2)));
            to(p, i, true), to(p, right), to(p, opposite), to(p, below);
            p.fill();
        }
        p.ink("ink", 1, 0.6);
        each_link([&](bool whole, int a, int b) { whole ? (to(p, a, true), to(p, b)) : void(); });
        p.stroke();
        p.ink("ink");
        for (int i = 0; i < points; ++i)
            if (hangs(i) || i == grabbed) p.dot(across(now[i].x), up(now[i].x), 4);
        if (torn.value > 0)
            p.text(-0.88, -1.43, still > 0 ? "orange: the first to tear" : "torn: Restart gives a new one");
        if (still == 0) return;
        p.ink("explicit", 3);
        each_link([&](bool whole, int a, int b) { whole ? void() : (to(p, a, true), to(p, b), p.stroke()); });
    }

    // The finger takes the nearest point, and pulls it in the plane in which it is; a ring takes
    // the rail with it.
    bool grab(double x, double y) override {
        double nearest = 0.15;
        grabbed = -1;
        for (int i = 0; i < points; ++i) {
            const double far = Eigen::Vector2d(across(now[i].x) - x, up(now[i].x) - y).norm();
            if (far < nearest) nearest = far, grabbed = i;
        }
        if (grabbed >= 0) drag(x, y);
        return grabbed >= 0;
    }
    void drag(double x, double y) override {
        if (grabbed < 0) return;  // started anew under the finger
        const double z = now[grabbed].x(2);
        finger = {std::fmin(std::fmax(x, -1.2), 1.2) - 0.35 * z, std::fmin(std::fmax(y, -1.5), 0.5) + 0.2 * z, z};
        if (hangs(grabbed)) rail = finger - start(grabbed);
    }
    void let_go() override { grabbed = -1; }
    bool handle(double& x, double& y) const override { return x = across(now[0].x), y = up(now[0].x), true; }

private:
    static constexpr int columns = 14, rows = 10, points = columns * rows;
    static constexpr double link = 0.1, width = (columns - 1) * link, floor = -1.4;  // m
    static constexpr double h = 1.0 / 60;                                            // s

    // Where a point is at the start; and is it a ring, which holds the cloth?
    static Vector3d start(int i) { return {i % columns * link - width / 2, -(i / columns) * link, 0}; }
    static bool hangs(int i) { return i == 0 || i == 4 || i == 9 || i == columns - 1; }

    // Wind pushes along the normal, the more the more it is faced: that takes positions only, as
    // Verlet must have it.
    Vector3d push_of_wind(int i) const {
        const int column = i % columns, row = i / columns;
        const Vector3d along = now[column < columns - 1 ? i + 1 : i].x - now[column > 0 ? i - 1 : i].x;
        const Vector3d down = now[row < rows - 1 ? i + columns : i].x - now[row > 0 ? i - columns : i].x;
        const Vector3d normal = direction(Vector3d(down.cross(along)));
        return wind * (1 + gust.x) * normal.dot(Vector3d(0.6, 0, 0.8)) * normal;
    }
    void put_right(int i, int j) {
        Vector3d &a = now[i].x, &b = now[j].x;
        const Vector3d excess = b - a - link * direction(Vector3d(b - a));
        const bool a_moves = !hangs(i) && i != grabbed, b_moves = !hangs(j) && j != grabbed;
        if (a_moves) a += excess / (1 + b_moves);
        if (b_moves) b -= excess / (1 + a_moves);
    }
    double length(int a, int b) const { return (now[b].x - now[a].x).norm(); }

    // Calls f(whole, a, b) for the links to the right of each point and below it.
    template <class F>
    void each_link(const F& f) {
        visit(*this, f);
    }
    template <class F>
    void each_link(const F& f) const {
        visit(*this, f);
    }
    template <class Self, class F>
    static void visit(Self& self, const F& f) {
        for (int i = 0; i < points; ++i) {
            if (i % columns < columns - 1) f(self.whole_across[i], i, i + 1);
            if (i < points - columns) f(self.whole_down[i], i, i + columns);
        }
    }
    void read() {
        double longest = 0;
        torn = 0;
        each_link([&](bool whole, int a, int b) {
            whole ? void(longest = std::fmax(longest, length(a, b))) : torn = torn.value + 1;
        });
        if (torn.value > 0 && !first_torn.known) {
            first_torn = static_cast<double>(steps);
            still = grabbed < 0 ? 90 : 0;
        }
        too_long = longest > 0 ? 100 * (longest / link - 1) : 0;
    }

    // The picture looks a little from above and from the side.
    static double across(const Vector3d& x) { return x(0) + 0.35 * x(2); }
    static double up(const Vector3d& x) { return x(1) - 0.2 * x(2); }
    void to(live::Picture& p, int i, bool first = false) const {
        first ? p.move(across(now[i].x), up(now[i].x)) : p.line(across(now[i].x), up(now[i].x));
    }

    live::Slider sweeps{this, "sweeps", "iterations a step", 1, 40, 1, 8};
    live::Slider wind{this, "wind", "wind", 0, 20, 0.5, 6, "m/s²"};
    live::Slider gravity{this, "gravity", "gravity", 0, 20, 0.01, 9.81, "m/s²"};
    live::Slider tears_at{this, "tears_at", "tears if too long by", 50, 300, 10, 150, "%"};
    live::Readout too_long{this, "the longest link", "% too long"};
    live::Readout torn{this, "torn links"}, first_torn{this, "the first tore at step"};

    std::array<State<Vector3d>, points> before, now;
    std::array<bool, points> whole_across, whole_down;
    State<double> gust_before{}, gust{};
    Vector3d finger, rail;
    int grabbed = -1, still = 0;  // the point in the finger, or -1; for how many steps all stands
};
LIVE_PANEL(Cloth)
