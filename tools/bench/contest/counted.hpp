#pragma once
// Counts a method's evaluations.

#include "contest.hpp"

namespace contest {

// A model that counts its evaluations, and otherwise is the one it wraps.
template <class Model>
struct Counted {
    const Model* model;
    Work* work;

    auto acceleration() const requires requires(const Model& m) { m.acceleration(); }
    { return ++work->evaluations, model->acceleration(); }
    /// [counted]
    template <class X>
    auto acceleration(const X& x) const requires requires(const Model& m, const X& y) {
        m.acceleration(y);
    }
    {
        ++work->evaluations;
        return model->acceleration(x);
    }
    /// [counted]
    template <class X>
    auto acceleration(const X& x, const X& v) const requires requires(const Model& m, const X& y) {
        m.acceleration(y, y);
    }
    { return ++work->evaluations, model->acceleration(x, v); }
    auto slope_x() const requires requires(const Model& m) { m.slope_x(); }
    { return ++work->solves, model->slope_x(); }
    template <class X>
    auto slope_x(const X& x) const requires requires(const Model& m, const X& y) {
        m.slope_x(y);
    }
    { return ++work->solves, model->slope_x(x); }
    template <class X>
    auto slope_x(const X& x, const X& v) const requires requires(const Model& m, const X& y) {
        m.slope_x(y, y);
    }
    { return ++work->solves, model->slope_x(x, v); }
    auto slope_v() const requires requires(const Model& m) { m.slope_v(); }
    { return model->slope_v(); }
    template <class X>
    auto slope_v(const X& x, const X& v) const requires requires(const Model& m, const X& y) {
        m.slope_v(y, y);
    }
    { return model->slope_v(x, v); }
};

}  // namespace contest
