#pragma once
// The course's methods as entries of a contest.

#include <cmath>

#include <timestep/methods.hpp>
#include <timestep/run.hpp>

#include "contest.hpp"

namespace contest {

inline volatile double sink;  // what a timed run finds goes here: the compiler has to compute it

// The coordinates of a state.
template <class X>
Place place(const timestep::State<X>& s) {
    if constexpr (std::is_arithmetic_v<X>)
        return {double(s.x)};
    else
        return Place(s.x.begin(), s.x.end());
}

// What the timed run is for.
template <class State>
void drain(const State& s) {
    if constexpr (std::is_arithmetic_v<decltype(s.x)>)
        sink = double(s.x);
    else
        sink = double(s.x[0]);
}

// Notes every `steps / marks`-th state but the start.
class Watch {
public:
    explicit Watch(long steps) : every_(steps / marks) {}
    template <class State>
    void operator()(const State& s) {
        if (seen_ > 0 && seen_ % every_ == 0) track_.push_back(place(s));
        ++seen_;
    }
    Track track() const { return track_; }

private:
    long every_, seen_ = 0;
    Track track_;
};

// A model that counts how often it is asked, and otherwise is the one it wraps.
template <class Model>
struct Counted {
    const Model* model;
    Work* work;

    auto acceleration() const requires requires(const Model& m) { m.acceleration(); } {
        return ++work->evaluations, model->acceleration();
    }
    /// [counted]
    template <class X>
    auto acceleration(const X& x) const
        requires requires(const Model& m, const X& y) { m.acceleration(y); }
    {
        ++work->evaluations;
        return model->acceleration(x);
    }
    /// [counted]
    template <class X>
    auto acceleration(const X& x, const X& v) const
        requires requires(const Model& m, const X& y) { m.acceleration(y, y); } {
        return ++work->evaluations, model->acceleration(x, v);
    }
    auto slope_x() const requires requires(const Model& m) { m.slope_x(); } {
        return ++work->solves, model->slope_x();
    }
    template <class X>
    auto slope_x(const X& x) const
        requires requires(const Model& m, const X& y) { m.slope_x(y); } {
        return ++work->solves, model->slope_x(x);
    }
    template <class X>
    auto slope_x(const X& x, const X& v) const
        requires requires(const Model& m, const X& y) { m.slope_x(y, y); } {
        return ++work->solves, model->slope_x(x, v);
    }
    auto slope_v() const requires requires(const Model& m) { m.slope_v(); } {
        return model->slope_v();
    }
    template <class X>
    auto slope_v(const X& x, const X& v) const
        requires requires(const Model& m, const X& y) { m.slope_v(y, y); } {
        return model->slope_v(x, v);
    }
};

template <class Method, class Model, class S>
Entry entry(const Method& method, const Model& model, const S& start, const std::string& library = "Timestep") {
    using Real = timestep::real_of<S>;
    const auto h = [](long steps) { return Real(duration / double(steps)); };
    Entry e{Method::name, library, {}, {}, {}};
    e.track = [=](long steps) {
        Watch watch(steps);
        run(method, model, start, h(steps), steps, watch);
        return watch.track();
    };
    e.run = [=](long steps) { drain(run(method, model, start, h(steps), steps)); };
    e.work = [=](long steps) {
        Work work;
        bool begun = false;  // what is asked before the first step is no part of it
        run(method, Counted<Model>{&model, &work}, start, h(steps), steps, [&](const S&) {
            if (!begun) work = {};
            begun = true;
        });
        work.steps = steps;
        return work;
    };
    return e;
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
    }
    enter(newton);
}

// The exact solution at the marks.
template <class Exact>
Track at_the_marks(const Exact& exact) {
    Track track;
    for (int mark = 1; mark <= marks; ++mark) track.push_back(place(exact(duration * mark / marks)));
    return track;
}

}  // namespace contest
