// Three flights: without air, through air, and with bounces.

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/scene.hpp>

#include "entries.hpp"
#include "peers.hpp"
#include "scenes.hpp"

using namespace timestep;

namespace contest {

namespace {

constexpr double g = 9.81;  // m/s²
const State thrown{0, Eigen::Vector2d(0, 0), Eigen::Vector2d(15, 20)};

template <class Real>
auto through_air() {
    // The same k in every precision.
    const double k = Drag<double>::from_terminal_speed(20.0, g).k;
    return timestep::Scene{Projectile(Eigen::Matrix<Real, 2, 1>(0, -g)), Drag<Real>(k)};
}

// A flight through air has no simple solution. This is Runge-Kutta 4 with long doubles.
Track through_air(long steps) {
    using Vector = Eigen::Matrix<long double, 2, 1>;
    const long double h = static_cast<long double>(duration) / steps;
    State s{0, Vector(0, 0), Vector(15, 20)};
    Track track;
    for (int mark = 0; mark < marks; ++mark) {
        s = run(runge_kutta_4, through_air<long double>(), s, h, steps / marks);
        track.push_back(place(s));
    }
    return track;
}

constexpr double restitution = 0.8;  // the speed after the bounce over the speed before
constexpr double drop = 5;           // m
const Drag<double> beach_ball = Drag<double>::from_terminal_speed(8.0, g);

// As games do it: take a step; if the ball is below the ground, mirror its height and its velocity.
template <class Method>
struct Bouncing {
    static constexpr const char* name = Method::name;
    Method method;

    template <class Model>
    State<double> step(const Model& model, const State<double>& state1, double h) const {
        State state2 = method.step(model, state1, h);
        if (state2.x < 0) {
            state2.x = -restitution * state2.x;
            state2.v = -restitution * state2.v;
        }
        return state2;
    }
};

// Where the ball is at the marks. With the terminal speed c = √(g/k), a ball that is thrown up with
// v₀ has the speed c tan(φ − gt/c), where tan φ = v₀/c, and one that falls c tanh(gt/c).
// Integrated:
//
//     up    y = c²/g · ln(cos(φ − gt/c) / cos φ),  at the top after cφ/g, at c²/2g · ln(1 + v₀²/c²)
//     down  y = top − c²/g · ln cosh(gt/c),        on the ground when cosh(gt/c) = exp(g·top/c²)
Track true_heights() {
    using Real = long double;
    const Real c = std::sqrt(Real(g) / Real(beach_ball.k));
    const Real second = c / Real(g), metre = c * second;
    Track track;
    Real begun = 0;  // when the ball left the ground; at first, when it was let go
    Real phi = 0, top = drop;
    while (int(track.size()) < marks) {
        const Real at_top = begun + second * phi;
        const Real landed = at_top + second * std::acosh(std::exp(top / metre));
        Real t;
        while (int(track.size()) < marks && (t = Real(duration) * (track.size() + 1) / marks) < landed) {
            const Real up = metre * std::log(std::cos(phi - (t - begun) / second) / std::cos(phi));
            const Real down = top - metre * std::log(std::cosh((t - at_top) / second));
            track.push_back({double(t < at_top ? up : down)});
        }
        const Real impact = std::tanh((landed - at_top) / second);  // as a share of c
        phi = std::atan(Real(restitution) * impact);
        top = -metre * std::log(std::cos(phi));
        begun = landed;
    }
    return track;
}

}  // namespace

Scene projectile() {
    Scene scene{"projectile", "a projectile without air", 20};
    const Projectile<Eigen::Vector2d> gravity({0, -g});
    scene.reference = at_the_marks([&](double t) { return gravity.exact(thrown, t); });
    enter_methods(scene, gravity, thrown);
    enter_peers(scene, gravity, thrown);
    return scene;
}

// The reference's error is its difference from a run with half as many steps, or the roundoff of a double.
Scene drag() {
    Scene scene{"drag", "a projectile in air, 20 m/s at most when it falls", 10};
    scene.reference = through_air(30L << 10);
    const Track rougher = through_air(30L << 9);
    scene.reference_error = 4 * std::numeric_limits<double>::epsilon();
    for (int mark = 0; mark < marks; ++mark)
        scene.reference_error = std::max(scene.reference_error, distance(scene, scene.reference[mark], rougher[mark]));
    enter_methods(scene, through_air<double>(), thrown);
    enter_peers(scene, through_air<double>(), thrown);
    return scene;
}

// Two-step methods are left out: after a bounce they would have to start again. The other libraries are left out, too:
// they would search for the moment of the bounce, which is another problem.
Scene bouncing_ball() {
    Scene scene{"bouncing_ball", "a ball that bounces five times", drop};
    scene.reference = true_heights();
    const timestep::Scene model{Projectile(-g), beach_ball};
    const State let_go{0, drop, 0.0};
    const auto enter = [&]<class Method>(const Method& method) {
        if constexpr (!TwoStepMethod<Method, decltype(model), State<double>>)
            scene.entries.push_back(entry(Bouncing<Method>{method}, model, let_go));
    };
    for_each_method(enter);
    enter(constant_acceleration);
    return scene;
}

}  // namespace contest
