#pragma once
/// \file
/// BDF2: a backward difference over two steps.

#include <limits>

#include <timestep/methods/implicit_midpoint.hpp>

namespace timestep {

/// The two-step backward differentiation formula (N35). The one-sided second-order difference
/// (3y₂ − 4y₁ + y₀)/2h stands in for the derivative at the end of the step. Second order, damped.
///
/// Solved for y₂ it reads y₂ = (4y₁ − y₀)/3 + (2h/3) f(y₂): implicit Euler from another start with
/// another step. The first step, which has no y₀, is an implicit midpoint step.
struct Bdf2 {
    static constexpr const char* name = "BDF2";                 ///< for tables and keys
    static constexpr int order = 2;                             ///< of the error after a whole run
    static constexpr Cost cost{.evaluations = 1, .solves = 1};  ///< of one step
    static constexpr bool takes_damping = true;  ///< does it step forces of the velocity?
    static constexpr bool steps_commute =
        true;  ///< on a spring: of any two lengths, in either order

    /// The first step, of length h in seconds, from one state alone.
    template <class Model, class S>
    [[nodiscard]] S start(const Model& model, const S& state0, real_of<S> h) const {
        return implicit_midpoint.step(model, state0, h);
    }

    /// One step of length h, in seconds, on from `state1`; `state0` is h before it.
    template <class Model, class X>
    [[nodiscard]] State<X> step(const Model& model, const State<X>& state0, const State<X>& state1,
                                real_of<X> h) const {
        const State<X> from{state1.t + h / 3,  //
                            (4 * state1.x - state0.x) / 3, (4 * state1.v - state0.v) / 3};
        return implicit_euler.step(model, from, 2 * h / 3);
    }

    /// One step of length h, in seconds, of a first-order system, on from `state1`; `state0` is h
    /// before it.
    template <class System, class Y>
    [[nodiscard]] FirstOrder<Y> step(const System& f, const FirstOrder<Y>& state0,
                                     const FirstOrder<Y>& state1, real_of<Y> h) const {
        const FirstOrder<Y> from{state1.t + h / 3, (4 * state1.y - state0.y) / 3};
        return implicit_euler.step(f, from, 2 * h / 3);
    }

    /// Refuses a step h that implicit Euler refuses.
    template <class Model, class S>
    void check_step(const Model& model, const S& s, real_of<S> h) const {
        implicit_euler.check_step(model, s, h);
    }
};

inline constexpr Bdf2 bdf2;  ///< the method as a value

/// A motion under BDF2 in a game, where impulses happen between the steps.
///
/// The formula assumes that the last two states lie on one smooth curve. After an impulse, a bounce
/// or a change of place they do not: a kick of 1 m/s, given to the latest state alone, becomes 1.5.
/// So call `restart` after each of those; it forgets the older state. A step of another length than
/// the one before is a restart too, because the formula is the one for equal steps.
/// [motion]
template <class S>
class Bdf2Motion {
public:
    explicit Bdf2Motion(const S& start) : now_(start), before_(start) {}  ///< begins here

    const S& now() const { return now_; }  ///< the latest state

    /// Goes on from `state`, whatever was before.
    void restart(const S& state) { now_ = before_ = state, last_h_ = none; }

    /// One step of length h, in seconds.
    template <class Model>
    void step(const Model& model, real_of<S> h) {
        const S next =
            h == last_h_ ? bdf2.step(model, before_, now_, h) : bdf2.start(model, now_, h);
        before_ = now_, now_ = next, last_h_ = h;
    }

private:
    static constexpr auto none = std::numeric_limits<real_of<S>>::quiet_NaN();  // equals no h
    S now_, before_;
    real_of<S> last_h_ = none;  // after a start or a restart
};
/// [motion]

}  // namespace timestep
