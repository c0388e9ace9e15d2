#pragma once
// The course's methods as entries of a contest.

#include <cmath>
#include <memory>
#include <string>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/run.hpp>

#include "counted.hpp"

namespace contest {

// The coordinates of a state.
template <class X>
Place place(const timestep::State<X>& s) {
    if constexpr (std::is_arithmetic_v<X>)
        return {double(s.x)};
    else
        return Place(s.x.begin(), s.x.end());
}

// The result of the timed run.
template <class State>
void drain(const State& s) {
    if constexpr (std::is_arithmetic_v<decltype(s.x)>)
        sink = double(s.x);
    else
        sink = double(s.x[0]);
}

// A method on a problem. One call takes all steps of a run, so the cost of the call does not count.
template <class S>
struct Stepper {
    using Real = timestep::real_of<S>;
    virtual ~Stepper() = default;

    virtual void advance(S& s, Real h, long steps) const = 0;      // s goes so many steps on
    virtual Work count(const S& s, Real h, long steps) const = 0;  // what these steps need
    virtual bool two_step() const = 0;                             // the next step depends on more than one state
};

template <class Method, class Model, class S>
struct StepperOf : Stepper<S> {
    using Real = timestep::real_of<S>;
    Method method;
    Model model;

    StepperOf(const Method& its_method, const Model& its_model) : method(its_method), model(its_model) {}

    void advance(S& s, Real h, long steps) const override { s = run(method, model, s, h, steps); }
    Work count(const S& s, Real h, long steps) const override {
        Work work{steps, 0, 0};
        run(method, Counted<Model>{&model, &work}, s, h, steps);
        return work;
    }
    bool two_step() const override { return timestep::TwoStepMethod<Method, Model, S>; }
};

// The places at the marks. A one-step method goes on from the last mark. A two-step method starts again at the
// beginning for each mark, and so does a run that has blown up: run() refuses to start from a NaN.
template <class S>
Track track(const Stepper<S>& stepper, const S& start, timestep::real_of<S> h, long steps) {
    const long every = steps / marks;
    Track track;
    S s = start;
    for (long mark = 1; mark <= marks; ++mark) {
        const bool anew = stepper.two_step() || !is_finite(s);
        if (anew) s = start;
        stepper.advance(s, h, anew ? mark * every : every);
        track.push_back(place(s));
    }
    return track;
}

template <class S>
Entry entry(const std::string& method, const std::string& library, std::unique_ptr<Stepper<S>> its_stepper,
            const S& start) {
    const std::shared_ptr<Stepper<S>> stepper = std::move(its_stepper);
    const auto h = [](long steps) { return timestep::real_of<S>(duration / double(steps)); };
    Entry e{method, library, {}, {}, {}};
    e.track = [=](long steps) { return track(*stepper, start, h(steps), steps); };
    e.run = [=](long steps) {
        S s = start;
        stepper->advance(s, h(steps), steps);
        drain(s);
    };
    e.work = [=](long steps) {
        const Work work = stepper->count(start, h(steps), steps);
        const Work before = stepper->count(start, h(steps), 0);  // run() evaluates the force, too
        return Work{steps, work.evaluations - before.evaluations, work.solves - before.solves};
    };
    return e;
}

template <class Method, class Model, class S>
Entry entry(const Method& method, const Model& model, const S& start, const std::string& library = "Timestep") {
    std::unique_ptr<Stepper<S>> stepper(new StepperOf<Method, Model, S>(method, model));
    return entry(Method::name, library, std::move(stepper), start);
}

// Enters every method of the course that steps this force.
template <class Model, class X>
void enter_methods(Scene& scene, const Model& model, const timestep::State<X>& start) {
    using namespace timestep;
    const auto enter = [&](const auto& method) { scene.entries.push_back(entry(method, model, start)); };
    for_each_method(enter);
    if constexpr (PositionForce<Model, X>) {
        enter(verlet);
        enter(velocity_verlet);
    } else if constexpr (LinearDamping<Model, X>) {
        enter(semi_implicit_euler_new_damping);  // without a damper it is semi-implicit Euler
    }
    enter(constant_acceleration);
}

// The exact solution at the marks.
template <class Exact>
Track at_the_marks(const Exact& exact) {
    Track track;
    for (int mark = 1; mark <= marks; ++mark) track.push_back(place(exact(duration * mark / marks)));
    return track;
}

}  // namespace contest
