// Misuses that must not compile, one after the other, each below its name: with MISUSE defined the first error
// says what its line  // error:  promises; without, it compiles. These headers are read before each.
#include <Eigen/Core>
#include <timestep/methods/explicit_euler.hpp>
#include <timestep/methods/implicit_euler.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/methods/verlet.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/run.hpp>
#include <timestep/scene.hpp>

using namespace timestep;

// ---- acceleration not const
// A method reads the model and does not change it, so the force must be a const member.
// error: timestep: a model needs a const member acceleration(), acceleration(x) or acceleration(x, v)
struct Pull {
#ifdef MISUSE
    double acceleration(double x) { return -x; }
#else
    double acceleration(double x) const { return -x; }
#endif
};

int main() { run(runge_kutta_4, Pull{}, State{0.0, 1.0, 0.0}, 0.1, 10); }

// ---- implicit system without derivative
// An implicit method solves for the new state and needs the system's derivative for that.
// error: timestep: implicit methods need the system's derivative slope_y(t, y)
struct Decay {
    double operator()(double, double y) const { return -y; }
#ifndef MISUSE
    double slope_y(double, double) const { return -1; }
#endif
};

int main() { run(implicit_euler, Decay{}, FirstOrder{0.0, 1.0}, 0.1, 10); }

// ---- implicit without derivatives
// The same for a force.
// error: timestep: implicit methods need the force's derivatives slope_x and slope_v
struct Cubic {
    double acceleration(double x) const { return -x * x * x; }
#ifndef MISUSE
    double slope_x(double x, double) const { return -3 * x * x; }
    double slope_v(double, double) const { return 0; }
#endif
};

int main() { run(implicit_euler, Cubic{}, State{0.0, 1.0, 0.0}, 0.1, 10); }

// ---- new damping nonlinear
// Damping at the new velocity is one division where the force is linear in the velocity, and only there.
// error: timestep: damping at the new velocity needs a force that is linear in the velocity, with slope_v()
struct Resistance {
#ifdef MISUSE
    double acceleration(double, double v) const { return -v * v; }
    double slope_x(double, double) const { return 0; }
    double slope_v(double, double v) const { return -2 * v; }
#else
    double acceleration(double, double v) const { return -v; }
    double slope_x() const { return 0; }
    double slope_v() const { return -1; }
#endif
};

int main() {
    const State start{0.0, 1.0, 0.0};
    run(semi_implicit_euler_new_damping, Resistance{}, start, 0.1, 10);
}

// ---- scalar force in scene
// Gravity in a scene is a vector where the position is one, as it is alone.
// error: timestep: the acceleration must be what the position is: a number, or a vector of the same size
int main() {
    const State start{0.0, Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(1, 0, 0)};
#ifdef MISUSE
    const Scene hung{Spring(2.0), Projectile(-9.81)};
#else
    const Scene hung{Spring(2.0), Projectile(Eigen::Vector3d(0, 0, -9.81))};
#endif
    run(semi_implicit_euler, hung, start, 0.01, 10);
}

// ---- system without f
// A first-order system is a function of t and y.
// error: timestep: a first-order system needs f(t, y)
int main() {
#ifdef MISUSE
    const auto f = [](double y) { return -y; };
#else
    const auto f = [](double, double y) { return -y; };
#endif
    run(explicit_euler, f, FirstOrder{0.0, 1.0}, 0.1, 10);
}

// ---- verlet with damper
// A damper needs a velocity, and plain Verlet keeps none.
// error: timestep: Verlet has no velocity to hand to a force: it needs acceleration() or acceleration(x)
int main() {
    const State start{0.0, 1.0, 0.0};
#ifdef MISUSE
    const DampedSpring model(2.0, 0.1);
#else
    const Spring model(2.0);
#endif
    run(verlet, model, start, 0.1, 10);
}
