// Misuses that must not compile, one after the other, each below its name: with MISUSE defined the first error
// says what its line  // error:  promises; without, it compiles. These headers are read before each.
#include <Eigen/Core>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/methods/semi_implicit_euler.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/rigid/body.hpp>
#include <timestep/rigid/inertia.hpp>
#include <timestep/rigid/omega.hpp>
#include <timestep/run.hpp>
#include <timestep/state.hpp>

using namespace timestep;

// ---- expression as state
// An Eigen expression refers to its operands and would outlive them.
// error: timestep: a state holds vectors, not Eigen expressions of them: State<Eigen::Vector3d>
int main() {
    const Eigen::Vector3d x(1, 2, 3);
#ifdef MISUSE
    const State<decltype(x + x)> start{0.0, x + x, x + x};
#else
    const State start{0.0, x + x, x + x};
#endif
    return start.x.x() > 2;
}

// ---- integer parameter
// With a whole number for ω the spring would compute in whole numbers.
// error: timestep: parameters are real numbers: write 1.0 instead of 1
int main() {
#ifdef MISUSE
    const Spring spring(10);
#else
    const Spring spring(10.0);
#endif
    return spring.omega > 20;
}

// ---- integer state
// Whole numbers would round every step to nothing.
// error: timestep: a state holds real numbers: write 1.0 instead of 1
int main() {
#ifdef MISUSE
    const State start{0, 1, 0};
#else
    const State start{0, 1.0, 0};
#endif
    return start.x > 2;
}

// ---- number and vector
// A position with three coordinates and a velocity with one.
// error: timestep: position and velocity are two numbers, or two vectors of one size
int main() {
    const Eigen::Vector3d x(1, 2, 3);
#ifdef MISUSE
    const State start{0.0, x, 0.0};
#else
    const State start{0.0, x, Eigen::Vector3d::Zero()};
#endif
    return start.x.x() > 2;
}

// ---- number for state
// A run starts from a state, not from a position.
// error: timestep: a run starts from a State{t, x, v} or a FirstOrder{t, y}
int main() {
#ifdef MISUSE
    const double start = 1.0;
#else
    const State start{0.0, 1.0, 0.0};
#endif
    run(semi_implicit_euler, Spring(10.0), start, 0.01, 10);
}

// ---- two kinds of real numbers
// A body's inertia in float, its state in double.
// error: timestep: the inertia and the state hold one kind of number: both float, or both double
int main() {
#ifdef MISUSE
    const PrincipalInertia<float> inertia(1, 2, 2.5f);
#else
    const PrincipalInertia<double> inertia(1, 2, 2.5);
#endif
    const RigidState<double> s{0, Quaternion<double>::Identity(), {1, 2, 3}};
    return step_rotation(calm_half_step, inertia, s, 0.01).omega.x() > 2;
}

// ---- world taken for body
// A spin in the world's axes, where the inertia's are the body's.
// error: timestep: this angular velocity is in the world's axes: hand over the orientation, too
int main() {
    const PrincipalInertia<double> inertia(1, 2, 2.5);
    const OmegaWorld<double> omega({1, 2, 3});
#ifdef MISUSE
    return after_gyroscopic_torque(calm_half_step, inertia, omega, 0.01).in_the_world.x() > 2;
#else
    const Quaternion<double> q = Quaternion<double>::Identity();
    return after_gyroscopic_torque(calm_half_step, inertia, q, omega, 0.01).in_the_world.x() > 2;
#endif
}

// ---- body taken for world
// And the other way round.
// error: timestep: this angular velocity is in the body's axes: it takes no orientation
int main() {
    const PrincipalInertia<double> inertia(1, 2, 2.5);
    const Quaternion<double> q = Quaternion<double>::Identity();
#ifdef MISUSE
    const OmegaBody<double> omega({1, 2, 3});
    return after_gyroscopic_torque(calm_half_step, inertia, q, omega, 0.01).in_the_body.x() > 2;
#else
    const OmegaBody<double> omega = in_body(q, OmegaWorld<double>({1, 2, 3}));
    return after_gyroscopic_torque(calm_half_step, inertia, omega, 0.01).in_the_body.x() > 2;
#endif
}

// ---- vector of a game
// A state has to know the real number type of a vector that is not Eigen's.
// error: timestep: a state needs `using Scalar = ...` in the vector that it holds: its real number type
struct Vec2 {
#ifndef MISUSE
    using Scalar = float;
#endif
    float x, y;
    friend Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
    friend Vec2 operator*(float s, const Vec2& a) { return {s * a.x, s * a.y}; }
};

int main() {
    const State start{0, Vec2{1, 2}, Vec2{0, 0}};
    return semi_implicit_euler.step(Spring(1.0f), start, 0.1f).x.x > 2;
}

// ---- vector without is_finite
// A run asks whether its start is finite.
// error: timestep: write `bool is_finite(const Vec3&)` beside a vector of your own
struct Vec1 {
    using Scalar = double;
    double x;
    friend Vec1 operator+(const Vec1& a, const Vec1& b) { return {a.x + b.x}; }
    friend Vec1 operator-(const Vec1& a, const Vec1& b) { return {a.x - b.x}; }
    friend Vec1 operator*(double s, const Vec1& a) { return {s * a.x}; }
    friend Vec1 operator/(const Vec1& a, double s) { return {a.x / s}; }
#ifndef MISUSE
    friend bool is_finite(const Vec1& a) { return std::isfinite(a.x); }
#endif
};

int main() {
    const State start{0, Vec1{1}, Vec1{0}};
    return run(semi_implicit_euler, Spring(1.0), start, 0.1, 1).x.x > 2;
}
