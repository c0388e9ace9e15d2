// Steps of four methods on a spring, and of semi-implicit Euler in four scenes: each by the library, and by a loop
// written by hand. The hand-written loops keep no time; nobody reads the library's here, so the compiler drops it too.

#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "cases.hpp"

namespace {

using namespace timestep;

constexpr double omega = 10, h = 0.001;

[[gnu::noinline]] double explicit_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        const double a = -omega * omega * x;
        x += h * v;
        v += h * a;
    }
    return x;
}

[[gnu::noinline]] double implicit_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v = (v + h * (-omega * omega * x)) / (1 + h * h * omega * omega);
        x += h * v;
    }
    return x;
}

[[gnu::noinline]] double runge_kutta_by_hand(double x, double v, long n) {
    const double k = -omega * omega;
    for (long i = 0; i < n; ++i) {
        const double x1 = v, v1 = k * x;
        const double x2 = v + h / 2 * v1, v2 = k * (x + h / 2 * x1);
        const double x3 = v + h / 2 * v2, v3 = k * (x + h / 2 * x2);
        const double x4 = v + h * v3, v4 = k * (x + h * x3);
        x = x + h / 6 * x1 + h / 3 * (x2 + x3) + h / 6 * x4;
        v = v + h / 6 * v1 + h / 3 * (v2 + v3) + h / 6 * v4;
    }
    return x;
}

// Semi-implicit Euler under an acceleration that is written out: a term that a scene does not name must not cost an
// instruction.
template <class Acceleration>
[[gnu::noinline]] double semi_implicit_by_hand(const Acceleration& a, double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * a(x, v);
        x += h * v;
    }
    return x;
}
constexpr double zeta = 0.1, drag = 0.25, g = 9.81;

template <class Method, class Model>
[[gnu::noinline]] double by_library(const Method& method, const Model& model, double x, double v, long n) {
    return run(method, model, State{0, x, v}, h, n).x;
}

}  // namespace

std::vector<Case> methods_and_scenes() {
    std::vector<Case> all;
    const auto add = [&](const std::string& name, const auto& library, const auto& hand) {
        all.push_back({name, 1000, [=](long n) { kept = library(unknown_one, 0, n); }});
        all.push_back({"hand_" + name, 1000, [=](long n) { kept = hand(unknown_one, 0, n); }});
    };
    const auto add_method = [&](const std::string& name, const auto& method, const auto& hand) {
        add(
            name, [&](double x, double v, long n) { return by_library(method, Spring(omega), x, v, n); }, hand);
    };
    const auto by_hand = [](const auto& a) {
        return [=](double x, double v, long n) { return semi_implicit_by_hand(a, x, v, n); };
    };
    const auto spring = [](double x, double) { return -omega * omega * x; };
    add_method("explicit_euler", explicit_euler, explicit_by_hand);
    add_method("semi_implicit_euler", semi_implicit_euler, by_hand(spring));
    add_method("implicit_euler", implicit_euler, implicit_by_hand);
    add_method("runge_kutta_4", runge_kutta_4, runge_kutta_by_hand);

    const auto in = [](const auto&... terms) {
        return [=](double x, double v, long n) { return by_library(semi_implicit_euler, Scene{terms...}, x, v, n); };
    };
    const auto add_scene = [&](const std::string& name, const auto& library, const auto& a) {
        add(name, library, by_hand(a));
    };
    const Projectile gravity(-g);
    const DampedSpring legs(omega, zeta);
    const auto braked = [](double v) { return drag * (v < 0 ? -v : v) * v; };
    const auto pull = [](double x, double v) { return -omega * omega * x - 2 * zeta * omega * v; };
    add_scene("gravity", in(gravity), [](double, double) { return -g; });
    add_scene("spring_gravity", in(Spring(omega), gravity), [](double x, double) { return -omega * omega * x - g; });
    add_scene("spring_damper_gravity", in(legs, gravity), [=](double x, double v) { return pull(x, v) - g; });
    add_scene("spring_damper_gravity_drag", in(legs, gravity, Drag(drag)),
              [=](double x, double v) { return pull(x, v) - g - braked(v); });
    add_scene("spring_damper_drag", in(legs, Drag(drag)), [=](double x, double v) { return pull(x, v) - braked(v); });
    add_scene("gravity_drag", in(gravity, Drag(drag)), [=](double, double v) { return -g - braked(v); });
    all.push_back({"spring_gravity_drag", 1000,
                   [=](long n) { kept = in(Spring(omega), gravity, Drag(drag))(unknown_one, 0, n); }});
    return all;
}
