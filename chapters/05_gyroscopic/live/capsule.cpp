// A capsule set on one end on a plane, or dropped from above it, and spun: who comes to rest, and
// who gains energy? Drag to look from elsewhere. still: steps=600

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/no_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/plane.hpp>
#include <timestep/rigid/shapes.hpp>

#include "live.hpp"
#include "solid.hpp"

using namespace timestep;
using plane::V;

class CapsuleOnPlane : public live::Panel {
public:
    CapsuleOnPlane() {
        title = "A capsule on a plane, its gyroscopic torque treated in five ways";
        aspect = 0.6, aspect_narrow = 1.3;
        solid.add_capsule(capsule.radius, capsule.half_length);
    }
    double seconds() const override { return 1 / rate; }
    // What the plane is like can be changed while they spin.
    bool restarts(const live::Control& c) const override { return &c != &rolling && &c != &spinning; }

    void restart() override {
        const double lean = dropped ? 0.6 : 0.05;  // rad
        const plane::Orientation leaning = plane::Orientation(1, lean / 2, 0, 0).normalized();
        const V axis = leaning * V::UnitZ(), halfway = (axis + V::UnitY()).normalized();
        now.fill(placed(capsule, leaning, spin * halfway, dropped ? 0.5 : 0));
        energy_at_start = energy(capsule, ground(), now[0]);
        spins.clear(), energies.clear();
        measure();
    }

    void step() override {
        advance(no_gyroscopic, 0);
        advance(lagged_inertia, 1);
        advance(implicit_gyroscopic, 2);
        advance(passive_gyroscopic, 3);
        advance(plane::AroundContacts<CalmHalfStep>{calm_half_step, 1 - place / 2.0}, 4);
        measure();
    }

    void draw(live::Picture& p) const override {
        const int columns = p.narrow ? 3 : 5, rows = p.narrow ? 2 : 1;
        p.window(0, columns * width, 0, rows * height, true, 0, 1, p.narrow ? 0.4 : 0.47, 1);
        for (int i = 0; i < 5; ++i) {
            const double x = (i % columns + 0.5) * width, y = (rows - i / columns - 0.72) * height;
            p.ink(names[i]);
            p.text(x - 0.46 * width, y + 0.62 * height, i == 1 ? "lagged inertia" : names[i]);
            draw_floor(p, now[i].x, x, y);
            if (!holds[i]) continue;
            const V above = view.seen(V(0, 0, now[i].x.z()));
            solid.draw(p, view, now[i].turning.q, x + above.x(), y + above.y());
        }
        spins.draw(p, names, false, 0, 0.5, p.narrow ? 0.4 : 0.47);
        energies.draw(p, names, false, 0.5, 1, p.narrow ? 0.4 : 0.47);
    }

    // A finger on a capsule turns the view.
    bool grab(double x, double y) override {
        view.grab(x, y);
        const double from_x = x - (std::floor(x / width) + 0.5) * width;
        const double from_y = y - (std::floor(y / height) + 0.5) * height;
        return y > 0 && from_x * from_x + from_y * from_y < 0.6 * 0.6;
    }
    void drag(double x, double y) override { view.drag(x, y); }
    bool handle(double& x, double& y) const override { return x = width / 2, y = height / 2, true; }

private:
    static constexpr double width = 1.3, height = 1.5;  // of a capsule's place in the picture, m
    static constexpr std::array names{no_gyroscopic.name, lagged_inertia.name, implicit_gyroscopic.name,
                                      passive_gyroscopic.name, calm_half_step.name};

    plane::Ground ground() const { return {9.81, 0.5, rolling, arms == 0 ? plane::Arms::start : plane::Arms::middle}; }
    template <class Solver>
    void advance(const Solver& solver, int i) {
        if (!holds[i]) return;
        plane::Contacts contacts;
        auto& [turning, x, v] = now[i] = plane::step(solver, capsule, ground(), now[i], 1 / rate, contacts);
        // Rolling resistance leaves the turning about the normal alone. Spinning resistance is the
        // same for that axis: it stops this turning, or takes off as much of it as the load allows.
        const V by_one = turning.q * capsule.inertia.velocity(turning.q.conjugate() * V::UnitZ());  // N m s
        const double load = contacts.at[0].normal + contacts.at[1].normal, most = spinning * capsule.radius * load;
        turning.omega -= std::clamp(turning.omega.z() / by_one.z(), -most, most) * by_one;
    }

    void measure() {
        for (std::size_t i = 0; i < 5; ++i) {
            const double speed = now[i].turning.omega.norm();
            if (!holds[i].holds(speed < 1000 && now[i].x.allFinite())) continue;
            const double share = energy(capsule, ground(), now[i]) / energy_at_start;
            left[i] = speed < 1e-9 ? 0 : share;  // what roundoff leaves is rest
            spins.add(i, now[i].turning.t, speed);
            energies.add(i, now[i].turning.t, share);
        }
    }

    // A square of the plane below the capsule. Its lines stay where they are in the world, and the
    // picture follows.
    void draw_floor(live::Picture& p, const V& centre, double x, double y) const {
        const double half = 0.6, gap = 0.3;
        const auto at = [&](double east, double north, bool begin) {
            const V place = view.seen(V(east, north, 0));
            begin ? p.move(x + place.x(), y + place.y()) : p.line(x + place.x(), y + place.y());
        };
        p.ink("soft", 1, 0.6);
        at(-half, -half, true), at(half, -half, false), at(half, half, false), at(-half, half, false), p.fill();
        p.ink("exact", 1);
        const auto first = [&](double middle) { return std::ceil((middle - half) / gap) * gap - middle; };
        for (double east = first(centre.x()); east <= half; east += gap) at(east, -half, true), at(east, half, false);
        for (double north = first(centre.y()); north <= half; north += gap)
            at(-half, north, true), at(half, north, false);
        p.stroke();
    }

    live::Choice dropped{this, "start", "at the start", "set on one end|dropped from half a metre, leaning"};
    live::Slider spin{this, "spin", "spin at the start", 5, 60, 1, 40, "rad/s"};
    live::Slider rolling{this, "rolling", "rolling resistance", 0, 0.3, 0.01, 0.1, "radii"};
    live::Slider spinning{this, "spinning", "spinning resistance", 0, 0.1, 0.005, 0, "radii"};
    live::Choice arms{this, "arms", "lever arms", "start of the step, as engines do|middle of the step"};
    live::Choice place{this, "place", "calm half-step",
                       "before the contacts|half before, half after|after the contacts", 2};
    live::Slider rate{this, "rate", "steps a second", 30, 240, 1, 60, "Hz"};
    // Under the names of the methods: the energy over that at the start.
    live::Readout left[5] = {{this, names[0]}, {this, names[1]}, {this, names[2]}, {this, names[3]}, {this, names[4]}};
    live::Fuse holds[5] = {{this, names[0]}, {this, names[1]}, {this, names[2]}, {this, names[3]}, {this, names[4]}};

    // 90 cm long, 30 cm thick, 1 kg.
    const plane::Capsule<SymmetricInertia<double>> capsule{timestep::capsule(1.0, 0.15, 0.6), 1, 0.15, 0.3};
    std::array<plane::BodyState, 5> now{};
    live::Chart<5> spins{"spin |ω|, rad/s", 200}, energies{"energy, at the start 1", 1.6};
    double energy_at_start = 1;
    live::Solid solid;
    live::View view;
};
LIVE_PANEL(CapsuleOnPlane)
