#pragma once
// The rules that stand for choice inside an engine.

#include <type_traits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/rigid/ball_and_remainder.hpp>

#include "engines/rule_in_engine.hpp"
#include "engines/spiers.hpp"

namespace engines {

// A rule as the adapters take it: the calm half-step by the plain functions, as is their default.
template <class Solver>
using InEngine = std::conditional_t<std::is_same_v<Solver, timestep::CalmHalfStep>, timestep::CalmInEngine,
                                    timestep::RuleInEngine<Solver>>;

// The passive step by the plain functions: for two equal moments a turn, which loses nothing.
struct PassiveInEngine : timestep::CalmInEngine {
    static bool step(const gyroscopic_bodyf& body, timestep::Vector3<float>& omega, float h) {
        if (gyroscopic_idlef(&body, omega.data())) return false;
        gyroscopic_passivef(&body, omega.data(), h);
        return true;
    }
    static bool step(const gyroscopic_body& body, timestep::Vector3<double>& omega, double h) {
        if (gyroscopic_idle(&body, omega.data())) return false;
        gyroscopic_passive(&body, omega.data(), h);
        return true;
    }
};

// The half-step Jacobian in n = ⌈2h √(2E/I_min)⌉ substeps: by the fastest that the body can get at its energy.
struct HalfStepInSubsteps {
    template <class Real>
    timestep::Vector3<Real> step(const timestep::PrincipalInertia<Real>& I, const timestep::Vector3<Real>& omega,
                                 Real h) const {
        const Real fastest = std::sqrt(I.unit.dot(omega.cwiseAbs2()) / I.unit.minCoeff());
        const int n = std::max(1, int(std::min(Real(64), std::ceil(2 * h * fastest))));
        timestep::Vector3<Real> w = omega;
        for (int i = 0; i < n; ++i) w = timestep::half_step_jacobian.step(I, w, h / Real(n));
        return w;
    }
};

// Of ball and remainder 2 what an engine can take: the new ω.
struct RemainderSpin {
    template <class Real>
    timestep::Vector3<Real> step(const timestep::PrincipalInertia<Real>& I, const timestep::Vector3<Real>& omega,
                                 Real h) const {
        return timestep::ball_and_remainder_2
            .step(I, timestep::SpinState<Real>{0, timestep::Quaternion<Real>::Identity(), omega}, h)
            .omega;
    }
};

// Calls `use(rule, name)` for each.
template <class Use>
void for_each_rule(const Use& use) {
    use(timestep::calm_half_step, "calm half-step");
    use(timestep::half_step_jacobian, "half-step Jacobian");
    use(HalfStepInSubsteps{}, "half-step in substeps");
    use(timestep::cayley_gyroscopic, "Cayley");
    use(timestep::passive_gyroscopic, "passive");
    use(RemainderSpin{}, "ball and remainder 2");
    use(timestep::AvianGyroscopic{}, "Avian proposed");
}

}  // namespace engines
