// A capsule falls on ice: first on one end, which slides off, and then on its side. Contacts make
// every method one of order one, whatever it is in the air (N36).
//
// On ice, because with friction and rolling resistance there may be no truth to measure against.
// The impulses of chapter 5 stop an end within one step, or within two, as the moment of the
// landing falls. Without friction that is the same; with it, two half blows are not one whole,
// since each is allowed its own friction and its own resistance. So the outcome depends on where in
// a step the landing falls, and shorter steps do not settle it: the tests show that.

#include <timestep/gyroscopic.hpp>
#include <timestep/rigid/shapes.hpp>

#include "bodies.hpp"
#include "scenes.hpp"
#include "sliding_capsule.hpp"

using namespace timestep;

namespace contest {

namespace {

using Body = SlidingCapsule::Body;

// The orientation, and the centre of mass: a metre counts as a radian.
Place place_of(const plane::BodyState& m) {
    Place all = place<double>(m.turning.q.toRotationMatrix());
    for (const double coordinate : m.x) all.push_back(radian * coordinate);
    return all;
}

// The work of the contacts is not counted. It is the same for all: up to four passes of twelve rounds.
template <class Solver>
struct OnPlane {
    Solver solver;
    Body body;
    plane::Ground ground;
    plane::BodyState start, m = start;
    plane::Contacts contacts = {};

    void restart() { m = start; }
    void step(double h) { m = plane::step(solver, body, ground, m, h, contacts); }
    void count(Work& work, double h) const { contest::count(work, solver, body.inertia, m.turning, h); }
    Place place() const { return place_of(m); }
    double number() const { return m.turning.q.w(); }
};

// Order four in the air: the step with contacts is taken back if there was none.
struct RungeKuttaInTheAir : OnPlane<PassiveGyroscopic> {
    FreeBody<SymmetricInertia<double>> free = FreeBody(body.inertia);

    void step(double h) {
        const plane::BodyState before = m;
        OnPlane::step(h);
        if (contacts.at[0].normal > 0 || contacts.at[1].normal > 0) return;
        const auto turning = runge_kutta_4.step(free, stacked(before.turning), h);
        const plane::V fall = h * ground.gravity * plane::V::UnitZ();
        m = {unstacked(orientation_scaled(turning)), before.x + h * (before.v - fall / 2), before.v - fall};
    }
    void count(Work& work, double h) const {
        OnPlane::count(work, h);
        work.evaluations += runge_kutta_4.cost.evaluations;
    }
};

}  // namespace

Scene capsule_on_plane() {
    Scene scene{"capsule_on_plane", "a capsule that falls on ice", radian};
    scene.patience = 10;
    const Body body{capsule(1.0, 0.15, 0.6), 1.0, 0.15, 0.3};  // 90 cm long, 30 cm thick, 1 kg
    const plane::Ground ice{9.81, 0.0, 0.0, plane::Arms::middle};
    const plane::Orientation leaning(Eigen::AngleAxisd(0.2, plane::V::UnitX()));
    const plane::BodyState start = plane::placed(body, leaning, {1, 0, 6}, 0.3);

    const SlidingCapsule exact(body, ice.gravity, start, 1000);
    for (int mark = 1; mark <= marks; ++mark) scene.reference.push_back(place_of(exact(duration * mark / marks)));
    scene.reference_error = 1e-11;  // as twice the slices change it, and the formulas' roundoff

    for_each_gyroscopic([&](const auto& solver) {
        using Solver = std::decay_t<decltype(solver)>;
        const OnPlane<Solver> at_start{solver, body, ice, start};
        scene.entries.push_back(stepped(solver.name, "Timestep", at_start));
    });
    // Chapter 5 says why contacts need the arms of the middle; on ice they do not.
    plane::Ground cheap = ice;
    cheap.arms = plane::Arms::start;
    const OnPlane<PassiveGyroscopic> cheaper{passive_gyroscopic, body, cheap, start};
    scene.entries.push_back(stepped("passive, arms of the start", "Timestep", cheaper));
    const RungeKuttaInTheAir at_start{{passive_gyroscopic, body, ice, start}};
    scene.entries.push_back(stepped("Runge-Kutta 4 in the air, passive", "Timestep", at_start));
    return scene;
}

}  // namespace contest
