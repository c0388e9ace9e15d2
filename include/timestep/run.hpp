#pragma once
/// \file
/// Many steps of one method: the loop around every picture of the course.

#include <optional>

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>

namespace timestep {

/// A method that needs the two latest states: it starts itself and steps from both.
template <class Method, class Model, class S>
concept TwoStepMethod = requires(const Method& m, const Model& f, const S& s, real_of<S> h) {
    { m.start(f, s, h) } -> std::same_as<S>;
    { m.step(f, s, s, h) } -> std::same_as<S>;
};

/// \cond
namespace detail {
// What can be wrong with the types that are handed to run().
template <class Method, class Model, class S, class Count, class Observe>
struct RunTypes {
    static_assert(
        requires(const S& s) { s.t; },
        "timestep: a run starts from a State{t, x, v} or a FirstOrder{t, y}");
    static_assert(
        TwoStepMethod<Method, Model, S> ||
            requires(const Method& m, const Model& f, const S& s, real_of<S> h) {
                { m.step(f, s, h) } -> std::same_as<S>;
            },
        "timestep: in run(method, model, start, h, steps) this method does not step this "
        "kind of state");
    static_assert(std::is_integral_v<Count> && !std::is_same_v<Count, bool>,
                  "timestep: in run(method, model, start, h, steps) steps is a whole number");
    static_assert(std::is_invocable_v<Observe&, const S&>,
                  "timestep: observe is called with each state, as in [](const auto& state) { }");
};

}  // namespace detail
/// \endcond

/// Takes `steps` steps of `h` seconds from `start` and returns the last state. Calls
/// `observe(state)` with the start and after each step.
///
/// The inputs are checked once, here. Throws `std::invalid_argument` if the step is not a finite
/// number above zero with a finite square, the count is negative or the start is not finite. A
/// method whose formulas hold more than that, such as an implicit step's divisor, has a member
/// `check_step(model, start, h)`, which is called here too. The result may be infinite or NaN,
/// because some methods blow up: ask is_finite(), or use checked_run().
template <class Method, class Model, class S, class Count, class Observe>
S run(const Method& method, const Model& model, const S& start, real_of<S> h, Count steps,
      Observe&& observe) {
    [[maybe_unused]] const detail::RunTypes<Method, Model, S, Count, Observe> types_fit;
    positive("step", h);
    if (!is_finite(h * h)) refuse("step", h, "so short that its square is finite");
    not_negative("steps", static_cast<double>(steps));
    if (!is_finite(start)) refuse("start: must be a finite state");
    if constexpr (requires { method.check_step(model, start, h); })
        method.check_step(model, start, h);

    observe(start);
    if (steps == 0) return start;
    if constexpr (TwoStepMethod<Method, Model, S>) {
        S before = start;
        S state = method.start(model, start, h);
        observe(state);
        for (Count i = 1; i < steps; ++i) {
            const S next = method.step(model, before, state, h);
            before = state;
            state = next;
            observe(state);
        }
        return state;
    } else {
        S state = start;
        for (Count i = 0; i < steps; ++i) {
            state = method.step(model, state, h);
            observe(state);
        }
        return state;
    }
}

/// Takes `steps` steps of `h` seconds from `start` and returns the last state, without an observer.
template <class Method, class Model, class S, class Count>
S run(const Method& method, const Model& model, const S& start, real_of<S> h, Count steps) {
    return run(method, model, start, h, steps, [](const S&) {});
}

/// The last state of a run, and the step at which it stopped being finite.
template <class S>
struct CheckedRun {
    S state;                         ///< the last state
    std::optional<long> blew_up_at;  ///< the first step whose state was not finite; empty if none
};

// One check at the end is enough: a step adds to the state, and a sum with an infinity or a NaN is
// never finite again. Only a run that has blown up is repeated, with a check of each state. A
// method that computes its velocity anew in each step (Verlet) may get a finite one back, so all of
// its states are checked.
/// Runs as run() does, and reports whether and when the state stopped being finite.
/// [checked]
template <class Method, class Model, class S, class Count>
[[nodiscard]] CheckedRun<S> checked_run(const Method& method, const Model& model, const S& start,
                                        real_of<S> h, Count steps) {
    if constexpr (!requires { requires Method::computes_velocity_anew; }) {
        const S end = run(method, model, start, h, steps);
        if (is_finite(end)) return {end, std::nullopt};
    }
    long seen = 0;
    std::optional<long> blew_up_at;
    const S end = run(method, model, start, h, steps, [&](const S& s) {
        if (!blew_up_at && !is_finite(s)) blew_up_at = seen;
        ++seen;
    });
    return {end, blew_up_at};
}
/// [checked]

}  // namespace timestep
