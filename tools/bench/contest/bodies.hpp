#pragma once
// Rigid bodies as entries of a contest, ours and other libraries'.

#include <memory>
#include <string>

#include <timestep/gyroscopic.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/free_body.hpp>

#include "runner.hpp"

namespace contest {

// A rotation matrix: nine numbers. Two orientations with an angle α between them are 2√2 sin(α/2)
// apart; with √2 as the size of the scene the error is 2 sin(α/2), the angle in radians while it is
// small, and never more than 2.
inline constexpr double radian = 1.4142135623730951;

template <class Real>
Place place(const timestep::Matrix3<Real>& R) {
    const timestep::Matrix3<double> numbers = R.template cast<double>();
    return Place(numbers.data(), numbers.data() + 9);
}

// A `Body` has restart(), which puts it back to the start; step(h); count(work, h), called before a step, which adds
// what that step evaluates and solves; place(); and number(), any number that depends on all steps.
template <class Body>
class BodyRunner : public Runner {
public:
    explicit BodyRunner(const Body& body) : body_(body) {}

    void restart(long steps) override { body_.restart(), h_ = duration / double(steps); }
    void advance(long n) override {
        Body body = body_;  // nobody else has a pointer to the copy: it may stay in registers
        for (long i = 0; i < n; ++i) body.step(h_);
        body_ = body;
    }
    Place place() const override { return body_.place(); }
    double number() const override { return double(body_.number()); }
    Work work(long steps) override {
        Work work;
        restart(steps);
        for (; work.steps < steps; ++work.steps) body_.count(work, h_), advance(1);
        return work;
    }

private:
    Body body_;
    double h_ = 0;
};

template <class Body>
Entry stepped(const std::string& method, const std::string& library, const Body& body) {
    return make_entry(method, library, std::make_unique<BodyRunner<Body>>(body));
}

// What one step needs. The gyroscopic torque ω × Iω is the force of a free body; a solve is one of three equations, by
// a formula or not.
template <class Solver, class Inertia, class Real>
void count(Work& work, const Solver& solver, const Inertia& inertia, const timestep::RigidState<Real>& s, Real h) {
    using namespace timestep;
    if constexpr (std::is_same_v<Solver, ConvergedGyroscopic> && std::is_same_v<Inertia, PrincipalInertia<Real>>) {
        const Vector3<Real> in_body = s.q.conjugate() * s.omega;
        (void)solver.step(inertia, in_body, h, [&] { ++work.evaluations, ++work.solves; });
    } else {
        const bool has_torque = !std::is_same_v<Solver, NoGyroscopic> && !std::is_same_v<Solver, LaggedInertia>;
        work.evaluations += has_torque;
        work.solves += has_torque && !std::is_same_v<Solver, ExplicitGyroscopic>;
    }
}

// Any gyroscopic solver of the course, with its update of the orientation.
template <class Solver, class Inertia>
struct Turning {
    using Real = typename Inertia::Scalar;
    Solver solver;
    Inertia inertia;
    timestep::RigidState<Real> start, s = start;

    void restart() { s = start; }
    void step(double h) { s = step_rotation(solver, inertia, s, Real(h)); }
    void count(Work& work, double h) const { contest::count(work, solver, inertia, s, Real(h)); }
    Place place() const { return contest::place<Real>(s.q.toRotationMatrix()); }
    Real number() const { return s.q.w(); }
};

// Runge-Kutta 4 on orientation and ω in one array. Its error takes the orientation off the rotations; once per step it
// is scaled back.
template <class Inertia>
struct TurningByRungeKutta {
    timestep::FreeBody<Inertia> model;
    timestep::RigidState<double> start;
    timestep::FirstOrder<typename timestep::FreeBody<Inertia>::Y> s = timestep::stacked(start);

    void restart() { s = timestep::stacked(start); }
    void step(double h) { s = timestep::orientation_scaled(timestep::runge_kutta_4.step(model, s, h)); }
    void count(Work& work, double h) const {
        const auto counted = [&](double t, const auto& y) { return ++work.evaluations, model(t, y); };
        static_cast<void>(timestep::runge_kutta_4.step(counted, s, h));
    }
    Place place() const { return contest::place<double>(unstacked(s).q.toRotationMatrix()); }
    double number() const { return s.y[3]; }
};

// Bullet's and ODE's bodies, turning freely, each defined where CMake has found the library. Neither uses two equal
// moments. Where our solvers do, `which` says that theirs do not: ", three moments".
void enter_bullet(Scene&, const timestep::PrincipalInertia<double>&, const timestep::RigidState<double>& start,
                  const std::string& which);
void enter_ode(Scene&, const timestep::PrincipalInertia<double>&, const timestep::RigidState<double>& start,
               const std::string& which);

}  // namespace contest
