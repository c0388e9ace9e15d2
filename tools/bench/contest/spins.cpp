// Two bodies that tumble freely: one with three moments, one with two equal ones. Both have an
// exact solution.

#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/shapes.hpp>

#include "bodies.hpp"
#include "scenes.hpp"

using namespace timestep;

namespace contest {

namespace {

// A spin that `float` represents exactly, so that all entries start alike.
template <class Real>
RigidState<Real> spun(double x, double y, double z) {
    return {0, Quaternion<Real>::Identity(), {Real(x), Real(y), Real(z)}};
}

template <class Solver, class Inertia>
void enter(Scene& scene, const Solver& solver, const Inertia& inertia,
           const RigidState<typename Inertia::Scalar>& start, const std::string& which = "") {
    scene.entries.push_back(stepped(solver.name + which, "Timestep", Turning<Solver, Inertia>{solver, inertia, start}));
}

// All solvers of the course, and Runge-Kutta.
template <class Inertia>
void enter_solvers(Scene& scene, const Inertia& inertia, const RigidState<double>& start) {
    for_each_gyroscopic([&](const auto& solver) { enter(scene, solver, inertia, start); });
    const TurningByRungeKutta<Inertia> body{FreeBody(inertia), start};
    scene.entries.push_back(stepped(runge_kutta_4.name, "Timestep", body));
}

// The other libraries, and ours in `float`, as Bullet computes.
void enter_others(Scene& scene, double I1, double I2, double I3, const RigidState<double>& start,
                  const std::string& which) {
    const PrincipalInertia<float> inertia{float(I1), float(I2), float(I3)};
    const RigidState<float> rounded{0, start.q.cast<float>(), start.omega.cast<float>()};
    enter(scene, implicit_gyroscopic, inertia, rounded, which + ", float");
#ifdef TIMESTEP_WITH_BULLET
    enter_bullet(scene, {I1, I2, I3}, start, which);
#endif
#ifdef TIMESTEP_WITH_ODE
    enter_ode(scene, {I1, I2, I3}, start, which);
#endif
}

// At the marks, in `long double`: the formulas' roundoff is below that of `double`.
template <class Exact>
Track orientations(const Exact& exact) {
    Track track;
    for (int mark = 1; mark <= marks; ++mark) {
        const auto q = exact((long double)(duration)*mark / marks);
        track.push_back(place<long double>(q.toRotationMatrix()));
    }
    return track;
}

}  // namespace

// A box with sides 1:2:3, of 12 kg so that its moments are whole numbers, spun about the middle
// one. It turns over twice.
Scene dzhanibekov() {
    Scene scene{"dzhanibekov", "a box that turns over, again and again", radian};
    const auto inertia = box(12.0, 1.0, 2.0, 3.0);
    const RigidState<double> start = spun<double>(0.25, 10, 0.25);
    const ExactFreeBody<long double> exact(box(12.0L, 1.0L, 2.0L, 3.0L), spun<long double>(0.25, 10, 0.25));
    scene.reference = orientations([&](long double t) { return exact(t).q; });
    scene.reference_error = 1e-12;  // an integration, which the tumble disturbs, agrees that well
    enter_solvers(scene, inertia, start);
    const auto& I = inertia.moments;
    enter_others(scene, I.x(), I.y(), I.z(), start, "");
    return scene;
}

// A capsule. Its axis goes round L at |L|/across, and the capsule round its axis besides:
//     q(t) = turn by |L| t/across about L, then turn by −precession_ratio ω_z t about z.
Scene symmetric_top() {
    Scene scene{"symmetric_top", "a capsule in the air", radian};
    const SymmetricInertia<double> inertia = capsule(1.0, 0.15, 0.6);
    const RigidState<double> start = spun<double>(2, 0, 6);
    scene.reference = orientations([&](long double t) {
        using Turn = Eigen::AngleAxis<long double>;
        const SymmetricInertia<long double> exactly(inertia.across, inertia.along);
        const Vector3<long double> omega = start.omega.cast<long double>();
        const Vector3<long double> L = exactly.momentum(omega);
        const long double about_L = L.norm() * t / exactly.across;
        const long double about_z = -exactly.precession_ratio * omega.z() * t;
        return Quaternion<long double>(Turn(about_L, L.normalized()) * Turn(about_z, Vector3<long double>::UnitZ()));
    });
    enter_solvers(scene, inertia, start);
    // Solvers that do not use the two equal moments.
    const std::string which = ", three moments";
    const PrincipalInertia<double> three(inertia.across, inertia.across, inertia.along);
    enter(scene, implicit_gyroscopic, three, start, which);
    enter(scene, passive_gyroscopic, three, start, which);
    enter_others(scene, inertia.across, inertia.across, inertia.along, start, which);
    return scene;
}

}  // namespace contest
