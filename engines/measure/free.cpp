// Four bodies that fly for a minute, beside the exact motion.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "scenes.hpp"

namespace engines {

namespace {

constexpr double lost = 0.5;  // rad: an orientation that nobody would call right

struct Flyer {
    const char* name;
    Shape shape;
    Vector axis;  // of the spin, nearly
    int watched;  // flips are counted by the sign of this component
};

Shape box(const Vector& half) {
    return {Shape::box, half, timestep::box(1.0, 2 * half.x(), 2 * half.y(), 2 * half.z()).moments, 1};
}

std::vector<Flyer> flyers() {
    const Vector tilted(0.01, 1, 0.01);
    return {{"box 1 x 2 x 3", box({0.5, 1, 1.5}), tilted, 1},
            {"staff", box({0.04, 0.05, 0.9}), Vector(1, 0.02, 0.5), 2},
            {"plate", box({0.5, 1, 0.05}), Vector(1, 0.01, 0.01), 0},
            {"capsule", {Shape::capsule, {0.15, 0.15, 0.3}, {1, 1.02, 0.18}, 10}, Vector(0.01, 0.01, 1), 2}};
}

struct Flight {
    double energy = 0, momentum = 0;  // what is left at the end
    double most = 1;                  // of the energy, ever
    double kept = 0;                  // s until the orientation is lost
    double along = 0;                 // what is left of the watched component's largest size, in the last ten seconds
    int flips = 0;
};

class Flips {
public:
    void see(double w) {
        if (w * before_ < 0) ++count;
        if (w != 0) before_ = w;
    }
    int count = 0;

private:
    double before_ = 0;
};

Flight flown(const Engine& engine, const Flyer& flyer, double spin, int steps, const std::vector<Quaternion>& truth) {
    const auto world = engine.world({});
    State start;
    start.omega = spin * flyer.axis.normalized();
    world->add(flyer.shape, start);
    const double E = spin_energy(flyer.shape, start), L = momentum(flyer.shape, start).norm();
    Flight flight;
    Flips flips;
    bool right = true;
    for (int n = 1; n <= steps; ++n) {
        world->step(step);
        const State s = world->state(0);
        const double w = in_body(s)[flyer.watched];
        flips.see(w);
        flight.most = std::max(flight.most, spin_energy(flyer.shape, s) / E);
        right = right && timestep::apart(truth[std::size_t(n)], s.q) < lost;
        if (right) flight.kept = n * step;
        if (n > steps - 600)
            flight.along = std::max(flight.along, std::fabs(w) / std::fabs(start.omega[flyer.watched]));
    }
    const State s = world->state(0);
    flight.energy = spin_energy(flyer.shape, s) / E;
    flight.momentum = momentum(flyer.shape, s).norm() / L;
    flight.flips = flips.count;
    return flight;
}

}  // namespace

void fly(const std::vector<Engine>& engines, const Effort& effort, Numbers& numbers) {
    const int steps = effort.quick ? 1200 : 3600;
    for (const Flyer& flyer : flyers())
        for (const double spin : {3.0, 10.0, 30.0, 100.0}) {
            timestep::RigidState<double> start{0, Quaternion::Identity(), spin * flyer.axis.normalized()};
            const timestep::PrincipalInertia<double> inertia(flyer.shape.moments.x(), flyer.shape.moments.y(),
                                                             flyer.shape.moments.z());
            const timestep::ExactFreeBody<double> exact(inertia, start);
            std::vector<Quaternion> truth;
            Flips flips;
            for (int n = 0; n <= steps; ++n) {
                const auto s = exact(n * step);
                truth.push_back(s.q);
                if (n > 0) flips.see((s.q.conjugate() * s.omega)[flyer.watched]);
            }
            std::printf("\n%s, %g rad/s, %g s alone; it truly flips %d times\n%-48s %8s %8s %8s %9s %6s %8s\n",
                        flyer.name, spin, steps * step, flips.count, "", "energy", "at most", "|L|", "right, s",
                        "flips", "spin");
            for (const Engine& engine : engines) {
                const Flight f = flown(engine, flyer, spin, steps, truth);
                std::printf("%s %8.3f %8.3f %8.3f %9.2f %6d %8.3f\n", row_name(engine).c_str(), f.energy, f.most,
                            f.momentum, f.kept, f.flips, f.along);
                char which[64];
                std::snprintf(which, sizeof which, "%s, %g rad/s", flyer.name, spin);
                numbers.add("alone", which, engine, "energy left", f.energy);
                numbers.add("alone", which, engine, "most energy", f.most);
                numbers.add("alone", which, engine, "momentum left", f.momentum);
                numbers.add("alone", which, engine, "right for, s", f.kept);
                numbers.add("alone", which, engine, "flips", f.flips);
                numbers.add("alone", which, engine, "true flips", flips.count);
            }
        }
}

}  // namespace engines
