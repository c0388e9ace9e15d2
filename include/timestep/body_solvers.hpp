#pragma once
/// \file
/// Every method of the course for a free body, for programs and tests that go through all of them.

#include <limits>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/strang.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>
#include <timestep/rigid/tumble.hpp>

namespace timestep {

/// LaggedInertia as a step of the whole body.
struct LaggedInertiaSpin {
    static constexpr const char* name = LaggedInertia::name;  ///< for tables and keys
    static constexpr int order = LaggedInertia::order;        ///< of the error after a whole run
    /// One step of `h` seconds.
    template <class Inertia, class Real>
    [[nodiscard]] SpinState<Real> step(const Inertia& inertia, const SpinState<Real>& s,
                                       Real h) const {
        return in_body(step_rotation(lagged_inertia, inertia, in_world(s), h));
    }
};

/// RungeKutta4, which treats the quaternion as four numbers; after each step it is scaled back.
struct RungeKuttaSpin {
    static constexpr const char* name = RungeKutta4::name;  ///< for tables and keys
    static constexpr int order = RungeKutta4::order;        ///< of the error after a whole run
    /// One step of `h` seconds.
    template <class Inertia, class Real>
    TIMESTEP_INLINE SpinState<Real> step(const Inertia& inertia, const SpinState<Real>& s,
                                         Real h) const {
        using Model = FreeBody<Inertia>;
        typename Model::Y y;
        y << s.q.coeffs(), s.omega;
        const FirstOrder<typename Model::Y> now{s.t, y};
        const auto next = runge_kutta_4.step(Model(inertia), now, h);
        const Quaternion<Real> q(Eigen::Matrix<Real, 4, 1>(next.y.template head<4>()));
        return {next.t, over_its_length(q), next.y.template tail<3>()};
    }
};

/// The work of one step, the same for every body.
struct BodyPrice {
    int torques = 0;   ///< gyroscopic torques
    int solves = 0;    ///< 3×3 equations solved, or a closed form that stands for them
    int turns = 0;     ///< rotations with a sine and a cosine
    bool told = true;  ///< false: the work varies from step to step
    /// The sum of the three; NaN if the work varies.
    double all() const {
        return told ? torques + solves + turns : std::numeric_limits<double>::quiet_NaN();
    }
};

/// Calls `visit(rule, price)` for each method, in the order of the course. The solvers of chapter 5
/// compute ω only; the mean of the old and the new ω rotates the body (Tumble).
template <class Visit>
void for_each_body_solver(const Visit& visit) {
    visit(tumble<ExplicitGyroscopic>, BodyPrice{1, 0, 0});
    visit(tumble<NoGyroscopic>, BodyPrice{});
    visit(LaggedInertiaSpin{}, BodyPrice{1, 0, 0});
    visit(tumble<ImplicitGyroscopic>, BodyPrice{1, 1, 0});
    visit(tumble<ConvergedGyroscopic>, BodyPrice{0, 0, 0, false});
    visit(tumble<PassiveGyroscopic>, BodyPrice{1, 1, 0});
    visit(tumble<HalfStepJacobian>, BodyPrice{1, 1, 0});
    visit(tumble<CalmHalfStep>, BodyPrice{0, 0, 0, false});
    visit(tumble<CayleyGyroscopic>, BodyPrice{1, 1, 0});
    visit(strang, BodyPrice{0, 0, 5});
    visit(ball_and_remainder_2, BodyPrice{0, 0, 4});
    visit(ball_and_remainder_4, BodyPrice{0, 0, 14});
    visit(RungeKuttaSpin{}, BodyPrice{4, 0, 0});
}

}  // namespace timestep
