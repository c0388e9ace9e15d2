// One throw, six ways to step it: spun about the intermediate axis, with a touch of the other two.
// Drag to look from elsewhere. still: steps=480

#include <algorithm>
#include <cmath>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/explicit_gyroscopic.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/lagged_inertia.hpp>
#include <timestep/gyroscopic/no_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/rigid/shapes.hpp>
#include <timestep/rigid/tumble.hpp>

#include "live.hpp"
#include "solid.hpp"

using namespace timestep;
using V = Vector3<double>;

// A wing nut: a block with a wing on each side, along z; its thread is along y. The sides and
// centres are such that the centre of mass is at zero. About each of them the blocks' moments add,
// by the parallel axis theorem.
struct Block {
    double mass;
    V centre, sides;
};
const Block wing_nut[] = {
    {5, V(0, -0.08, 0), V(0.3, 0.42, 0.3)},
    {1, V(0, 0.2, 0.33), V(0.07, 0.3, 0.36)},
    {1, V(0, 0.2, -0.33), V(0.07, 0.3, 0.36)},
};
PrincipalInertia<double> inertia_of_wing_nut() {
    V sum = V::Zero();
    for (const auto& [mass, c, sides] : wing_nut)
        sum +=
            box(mass, sides.x(), sides.y(), sides.z()).moments + mass * (V::Constant(c.squaredNorm()) - c.cwiseAbs2());
    return {sum.x(), sum.y(), sum.z()};
}

class Throw : public live::Panel {
public:
    Throw() {
        title = "A body in the air, stepped in six ways";
        aspect = 0.8, aspect_narrow = 1.4;
        solids[0].add_box(V::Zero(), V(1.0 / 3, 2.0 / 3, 1), 1);
        for (const Block& block : wing_nut) solids[1].add_box(block.centre, block.sides, 1);
        solids[2].add_box(V::Zero(), V(0.06, 0.06, 1.3), 2);
        solids[3].add_box(V::Zero(), V(0.04, 0.3, 1.2), 1);
    }
    double seconds() const override { return 1 / rate; }

    void restart() override {
        const Quaternion<double> upright = Quaternion<double>(1, 1, 0, 0).normalized();  // the body's y axis points up
        true_one = {0, upright, V(touch, spin, touch)};
        now.fill(in_world(true_one));
        energies.clear(), momenta.clear();
        with_body([&](const auto& inertia) {
            energy_at_start = kinetic_energy(inertia, now[0]);
            momentum_at_start = angular_momentum(inertia, now[0]).norm();
            measure(inertia);
        });
    }

    void step() override {
        with_body([&](const auto& inertia) {
            const double h = 1 / rate;
            // As good as exact: many short steps of chapter 8's solver, which keeps energy and |L|.
            // In the body's axes: there a zero stays zero, and what spins about one axis alone
            // never turns over.
            for (int n = 0; n < 100; ++n) true_one = tumble<CalmHalfStep>.step(inertia, true_one, h / 100);
            now[0] = in_world(true_one);
            now[1] = step_rotation(no_gyroscopic, inertia, now[1], h);
            if (holds[2]) now[2] = step_rotation(explicit_gyroscopic, inertia, now[2], h);
            if (holds[3]) now[3] = step_rotation(lagged_inertia, inertia, now[3], h);
            if (holds[4]) now[4] = step_rotation(implicit_gyroscopic, inertia, now[4], h);
            now[5] = step_rotation(passive_gyroscopic, inertia, now[5], h);
            measure(inertia);
        });
    }

    void draw(live::Picture& p) const override {
        const int columns = p.narrow ? 2 : 3, rows = 6 / columns;
        p.window(0, columns * width, 0, rows * height, true, 0, 1, p.narrow ? 0.33 : 0.4, 1);
        for (int i = 0; i < 6; ++i) {
            const double x = (i % columns + 0.5) * width, y = (rows - i / columns - 0.5) * height;
            p.ink(i == 0 ? "ink" : names[i]);
            p.text(x - 0.46 * width, y + 0.38 * height, i == 3 ? "lagged inertia" : names[i]);
            if (holds[i])
                solids[body].draw(p, view, now[i].q, x, y - 0.08 * height);
            else
                p.text(x - 0.2 * width, y, "blew up");
        }
        energies.draw(p, names, true, 0, 0.5, p.narrow ? 0.33 : 0.4);
        momenta.draw(p, names, true, 0.5, 1, p.narrow ? 0.33 : 0.4);
    }

    // A finger on a body turns the view.
    bool grab(double x, double y) override {
        const double from_x = x - (std::floor(x / width) + 0.5) * width;
        const double from_y = y - (std::floor(y / height) + 0.5) * height;
        view.grab(x, y);
        return y > 0 && from_x * from_x + from_y * from_y < 0.6 * 0.6;
    }
    void drag(double x, double y) override { view.drag(x, y); }
    bool handle(double& x, double& y) const override { return x = width / 2, y = height / 2, true; }

private:
    static constexpr double width = 1.75, height = 1.5;  // of a body's place in the picture, m
    static constexpr std::array names{"exact",
                                      no_gyroscopic.name,
                                      explicit_gyroscopic.name,
                                      lagged_inertia.name,
                                      implicit_gyroscopic.name,
                                      passive_gyroscopic.name};

    // A staff has two equal moments, and says so by its type: other closed forms step it.
    template <class Use>
    void with_body(const Use& use) {
        if (body == 2) return use(a_staff);
        use(body == 0 ? a_box : body == 1 ? a_wing_nut : a_plank);
    }

    template <class Inertia>
    void measure(const Inertia& inertia) {
        for (std::size_t i = 0; i < 6; ++i) {
            if (!holds[i]) continue;
            const double energy = kinetic_energy(inertia, now[i]) / energy_at_start;
            const double momentum = angular_momentum(inertia, now[i]).norm() / momentum_at_start;
            if (!holds[i].holds(energy < 1e6)) continue;
            left[i] = energy;
            energies.add(i, now[i].t, energy);
            momenta.add(i, now[i].t, momentum);
        }
    }

    live::Choice body{this, "body", "body", "box 1:2:3|wing nut|staff|plank"};
    live::Slider spin{this, "spin", "spin, intermediate axis", 1, 60, 0.5, 12, "rad/s"};
    live::Slider touch{this, "touch", "spin, other axes", 0, 10, 0.05, 0.05, "rad/s"};
    live::Slider rate{this, "rate", "steps a second", 30, 240, 1, 60, "Hz"};
    // Under the names of the methods: the energy over that at the start.
    live::Readout left[6] = {{this, names[0]}, {this, names[1]}, {this, names[2]},
                             {this, names[3]}, {this, names[4]}, {this, names[5]}};
    live::Fuse holds[6] = {{this, names[0]}, {this, names[1]}, {this, names[2]},
                           {this, names[3]}, {this, names[4]}, {this, names[5]}};

    const PrincipalInertia<double> a_box = box(1.0, 1.0 / 3, 2.0 / 3, 1.0), a_wing_nut = inertia_of_wing_nut(),
                                   a_plank = box(1.0, 0.04, 0.3, 1.2);
    const SymmetricInertia<double> a_staff = staff(1.0, 1.3, 0.06);
    SpinState<double> true_one{};  // the exact body, in its axes
    std::array<RigidState<double>, 6> now{};
    live::Chart<6> energies{"energy, at the start 1", 3}, momenta{"|L|, at the start 1", 3};
    double energy_at_start = 1, momentum_at_start = 1;
    std::array<live::Solid, 4> solids;
    live::View view;
};
LIVE_PANEL(Throw)
