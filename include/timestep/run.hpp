#pragma once
/// \file
/// Many steps of one method: the loop around every picture of the course.

#include <timestep/checks.hpp>
#include <timestep/forces.hpp>
#include <timestep/linear_solve.hpp>

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

// The numbers that a step's formulas hold: h²; of a linear force 1 − h ∂a/∂v − h² ∂a/∂x, by which
// an implicit step divides; of a first-order system that has a slope, 1 − h ∂f/∂y at the start. (A
// slope that is itself no number, as that of √y at zero, harms no explicit method.)
template <class Model, class S>
void check_step(const Model& model, const S& s, real_of<S> h) {
    bool good = is_finite(h * h);
    if constexpr (requires { requires LinearForce<Model, std::decay_t<decltype(s.x)>>; })
        good = good &&
               is_finite(implicit_matrix(h, slope_v(model, s.x, s.v), slope_x(model, s.x, s.v)));
    if constexpr (requires { model.slope_y(s.t, s.y); }) {
        const auto& slope = model.slope_y(s.t, s.y);
        good = good && (!is_finite(slope) || is_finite(implicit_matrix(h, slope, real_of<S>(0))));
    }
    if (!good)
        refuse("step", h, "so short that its square, and that times the force's slope, is finite");
}
}  // namespace detail
/// \endcond

/// Takes `steps` steps of `h` seconds from `start` and returns the last state. Calls
/// `observe(state)` with the start and after each step.
///
/// The inputs are looked at once, here: throws `std::invalid_argument` when the step is not a
/// finite number above zero, the count is negative or the start is not finite; and when h², or for
/// a linear force 1 − h ∂a/∂v − h² ∂a/∂x, or for a first-order system h ∂f/∂y at the start, is too
/// large for a number. Whether the result is finite is for the caller to ask, with is_finite():
/// some methods blow up, and a course shows it.
template <class Method, class Model, class S, class Count, class Observe>
S run(const Method& method, const Model& model, const S& start, real_of<S> h, Count steps,
      Observe&& observe) {
    [[maybe_unused]] const detail::RunTypes<Method, Model, S, Count, Observe> types_fit;
    positive("step", h);
    not_negative("steps", static_cast<double>(steps));
    if (!is_finite(start)) refuse("start: must be a finite state");
    detail::check_step(model, start, h);

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

/// The same without an observer.
template <class Method, class Model, class S, class Count>
S run(const Method& method, const Model& model, const S& start, real_of<S> h, Count steps) {
    return run(method, model, start, h, steps, [](const S&) {});
}

struct Verlet;

/// A run whose result has been looked at.
template <class S>
struct CheckedRun {
    S state;          ///< the last one
    long blew_up_at;  ///< the first step after which the state was not finite; 0 if it always was
};

/// The same run, and one look at its result. One is enough: a step adds to what is there, and of
/// what is not a finite number no sum is one again. Only a run that has blown up is repeated, with
/// a look at each state, to say when. (Verlet's velocity is no part of the sum, and may come back:
/// its runs are looked at state by state.) [checked]
template <class Method, class Model, class S, class Count>
CheckedRun<S> checked_run(const Method& method, const Model& model, const S& start, real_of<S> h,
                          Count steps) {
    if constexpr (!std::is_same_v<Method, Verlet>) {
        const S end = run(method, model, start, h, steps);
        if (is_finite(end)) return {end, 0};
    }
    long seen = 0, blew_up_at = 0;
    const S end = run(method, model, start, h, steps, [&](const S& s) {
        if (blew_up_at == 0 && !is_finite(s)) blew_up_at = seen;
        ++seen;
    });
    return {end, blew_up_at};
}
/// [checked]

}  // namespace timestep
