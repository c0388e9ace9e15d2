#pragma once
/// \file
/// The game loop: frames of any length, and a simulation in steps of one size.

#include <cmath>

#include <timestep/checks.hpp>

namespace timestep {

/// A fixed time step behind any frame rate (I02).
///
/// The loop accumulates the time that passes on the player's clock. Each frame takes as many whole
/// steps as fit, and the rest, less than a step, stays in the accumulator. So the state after step
/// n depends on n and on the inputs of the steps, never on the frames: it has the same bits at 30
/// and at 144 frames per second. (Inputs that arrive with a frame belong to the next step; a replay
/// stores their steps.)
///
/// If steps take longer to compute than the time they simulate, each frame has more to do than the
/// one before: the spiral of death. The cap `most_steps` ends it. Time beyond the cap is dropped,
/// and the game runs slower than the clock instead of not at all.
template <class Real>
class GameLoop {
public:
    /// `step` in s, above zero; at most `most_steps` per frame, one or more.
    /// Throws `std::invalid_argument`.
    GameLoop(Real step, long most_steps) : step_(positive("step", step)), most_steps_(most_steps) {
        if (most_steps < 1) refuse("most steps", static_cast<double>(most_steps), "one or more");
    }

    /// Call this once per frame with the seconds since the last one. Calls `simulate(h)` for each
    /// step that is due and returns their number. Throws `std::invalid_argument` if `passed` is
    /// negative or not finite, or if the accumulated time is too large for a number.
    /// [frame]
    template <class Simulate>
    long frame(Real passed, Simulate&& simulate) {
        owed_ = not_negative("time owed", owed_ + not_negative("frame time", passed));
        long count = 0;
        for (; owed_ >= step_ && count < most_steps_; ++count) {
            simulate(step_);
            owed_ -= step_;
            ++steps_;  // each step sees its own number, whatever the frame
        }
        if (owed_ >= step_) drop_whole_steps();
        return count;
    }
    /// [frame]

    /// The accumulated time as a part of a step, from 0 to below 1: how far the player's clock is
    /// past the last step.
    Real alpha() const { return owed_ / step_; }

    /// The number of steps since the start; inside `simulate`, the number before this one.
    long steps() const { return steps_; }

    /// The simulated time, s. It is counted, not added up: `steps() * step` is rounded once (twice
    /// if the type cannot hold the count, in `float` from 2²⁴ steps on). Adding a step to a clock
    /// rounds every time, and in `float` the errors show within an hour.
    Real time() const { return static_cast<Real>(steps_) * step_; }

    /// The time, s, that the cap has dropped.
    Real dropped() const { return dropped_; }

private:
    void drop_whole_steps() {
        const Real kept = std::fmod(owed_, step_);  // exact, and below one step
        dropped_ += owed_ - kept;
        owed_ = kept;
    }

    Real step_;
    long most_steps_;
    Real owed_ = 0;
    Real dropped_ = 0;
    long steps_ = 0;
};

/// \cond
template <class Real>
GameLoop(Real, long) -> GameLoop<Real>;
/// \endcond

/// The state to draw: a part `alpha` (0 to 1) of the way from the last state but one to the last.
/// The picture is one step late and moves evenly at any frame rate.
template <class X>
State<X> interpolate(const State<X>& before, const State<X>& now, real_of<X> alpha) {
    const real_of<X> rest = 1 - alpha;
    return {rest * before.t + alpha * now.t, rest * before.x + alpha * now.x,
            rest * before.v + alpha * now.v};
}

}  // namespace timestep
