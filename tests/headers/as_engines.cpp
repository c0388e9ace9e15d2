// What an engine may make of the library, in float and in double: compiled after every header, with the warnings,
// languages and switches that engines have. Refuses a mass of minus one when it is given an argument.
#include <cstdio>

#include <timestep/rigid/shapes.hpp>

#ifdef ONLY_REFUSE
int main() { [[maybe_unused]] const auto refused = timestep::box(-1.0, 1.0, 1.0, 1.0); }
#else

#include <timestep/body_solvers.hpp>
#include <timestep/methods.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/run.hpp>

using namespace timestep;

namespace {

template <class Real>
Real fly() {
    const auto crate = box(Real(12), Real(1), Real(2), Real(3));
    const auto pill = capsule(Real(1), Real(0.2), Real(1));
    SpinState<Real> s{0, Quaternion<Real>::Identity(), {1, 2, 3}};
    for_each_body_solver([&](const auto& method, const BodyPrice&) { s = method.step(crate, s, Real(0.01)); });
    s = ball_and_remainder_4.step(pill, s, Real(0.01));
    const FullInertia<Real> full(Matrix3<Real>(crate.moments.asDiagonal()));
    RigidState<Real> world{0, s.q, s.omega};
    for_each_gyroscopic([&](const auto& solver) { world = step_rotation(solver, full, world, Real(0.01)); });
    world = step_rotation(calm_half_step, pill, world, Vector3<Real>(1, 2, 3), Real(0.01));
    return world.omega.norm();
}

template <class Real>
Real swing() {
    const DampedSpring<Real> spring(Real(10), Real(0.1));
    State<Real> s{0, 1, 0};
    s = run(semi_implicit_euler, spring, s, Real(0.01), 10);
    s = run(implicit_euler, spring, s, Real(0.01), 10);
    s = run(runge_kutta_4, spring, s, Real(0.01), 10);
    return s.x;
}

}  // namespace

int main(int argc, char**) {
    std::printf("%g %g %g %g\n", double(fly<float>()), fly<double>(), double(swing<float>()), swing<double>());
    if (argc > 1) [[maybe_unused]]
        const auto refused = box(-1.0, 1.0, 1.0, 1.0);
}
#endif
