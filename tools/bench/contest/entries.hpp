#pragma once
// The course's methods as entries of a contest.

#include <memory>
#include <string>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/run.hpp>

#include "counted.hpp"
#include "runner.hpp"

namespace contest {

// The coordinates of a state.
template <class X>
Place place(const timestep::State<X>& s) {
    if constexpr (std::is_arithmetic_v<X>)
        return {double(s.x)};
    else
        return Place(s.x.begin(), s.x.end());
}

// A method of the course on a model.
template <class Method, class Model, class S>
class StateRunner : public Runner {
    using Real = timestep::real_of<S>;

public:
    StateRunner(const Method& method, const Model& model, const S& start)
        : method_(method), model_(model), start_(start) {}

    void restart(long steps) override { s_ = start_, h_ = Real(duration / double(steps)); }
    void advance(long n) override { s_ = run(method_, model_, s_, h_, n); }
    Place place() const override { return contest::place(s_); }
    double number() const override {
        if constexpr (std::is_arithmetic_v<decltype(s_.x)>)
            return double(s_.x);
        else
            return double(s_.x[0]);
    }
    Work work(long steps) override {
        const auto count = [&](long n) {
            Work work;
            run(method_, Counted<Model>{&model_, &work}, start_, Real(duration / double(steps)), n);
            return work;
        };
        const Work all = count(steps), before = count(0);  // run() evaluates the force, too
        return {steps, all.evaluations - before.evaluations, all.solves - before.solves};
    }
    // A two-step method needs more than one state, and run() refuses to start from a NaN.
    bool stuck() const override { return timestep::TwoStepMethod<Method, Model, S> || !is_finite(s_); }

private:
    Method method_;
    Model model_;
    S start_, s_ = start_;
    Real h_ = 0;
};

template <class Method, class Model, class S>
Entry entry(const Method& method, const Model& model, const S& start, const std::string& library = "Timestep") {
    return make_entry(Method::name, library, std::make_unique<StateRunner<Method, Model, S>>(method, model, start));
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
