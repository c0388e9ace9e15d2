// Takes a number of steps with one method, or with several, one after the other: a program for a profiler to
// count. `steps semi_implicit_euler 1000` steps the library, `steps hand_semi_implicit_euler 1000`
// the same loop written by hand; `steps spring_gravity 1000` steps a scene. The hand-written loops keep no time; nobody
// reads the library's here, so the compiler drops it too.

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

#include "count.hpp"

namespace {

using namespace timestep;

constexpr double omega = 10, h = 0.001;

template <class Method>
[[gnu::noinline]] double by_library(const Method& method, double x, double v, long n) {
    return run(method, Spring(omega), State{0, x, v}, h, n).x;
}

[[gnu::noinline]] double explicit_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        const double a = -omega * omega * x;
        x += h * v;
        v += h * a;
    }
    return x;
}

[[gnu::noinline]] double semi_implicit_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * (-omega * omega * x);
        x += h * v;
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

// Scenes of more and more forces, stepped by semi-implicit Euler: a term that a scene does not name
// must not cost an instruction.
constexpr double zeta = 0.1, drag = 0.25, g = 9.81;

template <class Model>
[[gnu::noinline]] double scene_by_library(const Model& scene, double x, double v, long n) {
    return run(semi_implicit_euler, scene, State{0, x, v}, h, n).x;
}

[[gnu::noinline]] double gravity_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * -g;
        x += h * v;
    }
    return x;
}

[[gnu::noinline]] double spring_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * (-omega * omega * x - g);
        x += h * v;
    }
    return x;
}

[[gnu::noinline]] double legs_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        v += h * (-omega * omega * x - 2 * zeta * omega * v - g);
        x += h * v;
    }
    return x;
}

[[gnu::noinline]] double drag_by_hand(double x, double v, long n) {
    for (long i = 0; i < n; ++i) {
        const double speed = v < 0 ? -v : v;
        v += h * (-omega * omega * x - 2 * zeta * omega * v - g + -drag * speed * v);
        x += h * v;
    }
    return x;
}

void take(const char* what, long n) {
    const double x = unknown_one, v = 0;
    double end = 0;
    if (!std::strcmp(what, "hand_explicit_euler"))
        end = explicit_by_hand(x, v, n);
    else if (!std::strcmp(what, "hand_semi_implicit_euler"))
        end = semi_implicit_by_hand(x, v, n);
    else if (!std::strcmp(what, "hand_implicit_euler"))
        end = implicit_by_hand(x, v, n);
    else if (!std::strcmp(what, "hand_runge_kutta_4"))
        end = runge_kutta_by_hand(x, v, n);
    else if (!std::strcmp(what, "explicit_euler"))
        end = by_library(explicit_euler, x, v, n);
    else if (!std::strcmp(what, "semi_implicit_euler"))
        end = by_library(semi_implicit_euler, x, v, n);
    else if (!std::strcmp(what, "implicit_euler"))
        end = by_library(implicit_euler, x, v, n);
    else if (!std::strcmp(what, "runge_kutta_4"))
        end = by_library(runge_kutta_4, x, v, n);
    else if (!std::strcmp(what, "hand_gravity"))
        end = gravity_by_hand(x, v, n);
    else if (!std::strcmp(what, "hand_spring_gravity"))
        end = spring_by_hand(x, v, n);
    else if (!std::strcmp(what, "hand_spring_damper_gravity"))
        end = legs_by_hand(x, v, n);
    else if (!std::strcmp(what, "hand_spring_damper_gravity_drag"))
        end = drag_by_hand(x, v, n);
    else if (!std::strcmp(what, "gravity"))
        end = scene_by_library(Scene{Projectile(-g)}, x, v, n);
    else if (!std::strcmp(what, "spring_gravity"))
        end = scene_by_library(Scene{Spring(omega), Projectile(-g)}, x, v, n);
    else if (!std::strcmp(what, "spring_damper_gravity"))
        end = scene_by_library(Scene{DampedSpring(omega, zeta), Projectile(-g)}, x, v, n);
    else if (!std::strcmp(what, "spring_damper_gravity_drag"))
        end = scene_by_library(Scene{DampedSpring(omega, zeta), Projectile(-g), Drag(drag)}, x, v, n);
    else
        std::exit((std::fprintf(stderr, "steps: %s: no such method\n", what), 2));
    kept = end;
}

}  // namespace

int main(int argc, char** argv) {
    const auto one = [](char** words, long n) { take(words[0], n); };
    if (!count_all(argc, argv, 1, one)) return std::fputs("steps: usage: steps METHOD COUNT ...\n", stderr), 2;
}
