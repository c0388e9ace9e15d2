#pragma once
// Any method, on one kind of force, as plain functions. What takes one of these is compiled once,
// and not once more for every method. (A call through a pointer costs a few nanoseconds a step:
// nothing that is timed goes this way.)

#include <type_traits>

#include <timestep/methods.hpp>
#include <timestep/methods/semi_implicit_euler_new_damping.hpp>
#include <timestep/run.hpp>

// Every method of the course.
template <class Visit>
void for_all_methods(const Visit& visit) {
    timestep::for_each_method(visit);
    visit(timestep::semi_implicit_euler_new_damping);
    timestep::for_each_verlet_method(visit);
}

// Does the method step this kind of state under this force? Verlet's kind has no velocity to hand
// to the force, new damping wants one that is linear in it, and a first-order system is not for
// methods that treat position and velocity differently.
template <class Method, class Model, class S>
constexpr bool takes() {
    using namespace timestep;
    if constexpr (requires(S s) { s.x; }) {
        using X = std::decay_t<decltype(S::x)>;
        if constexpr (!Method::takes_damping)
            return PositionForce<Model, X>;
        else if constexpr (std::is_same_v<Method, SemiImplicitEulerNewDamping>)
            return LinearDamping<Model, X>;
        else
            return true;
    } else {
        return TwoStepMethod<Method, Model, S> || requires(const Method& m, const Model& f, S s, real_of<S> h) {
            m.step(f, s, h);
        };
    }
}

// As a method of two steps, which run() takes. One that needs the latest state only does not look
// at the one before.
template <class Model, class S>
struct AnyMethod {
    using Real = timestep::real_of<S>;

    const char* name;
    S(*from_one)
    (const Model&, const S&, Real) = nullptr;  // stays null where the force is not taken
    S (*from_two)(const Model&, const S&, const S&, Real) = nullptr;
    void (*check)(const Model&, const S&, Real) = nullptr;

    template <class Method>
    AnyMethod(const Method&) : name(Method::name) {
        if constexpr (takes<Method, Model, S>() &&
                      requires(const Model& f, const S& s, Real h) { Method{}.check_step(f, s, h); })
            check = [](const Model& f, const S& s, Real h) { Method{}.check_step(f, s, h); };
        if constexpr (!takes<Method, Model, S>()) {
            return;
        } else if constexpr (timestep::TwoStepMethod<Method, Model, S>) {
            from_one = [](const Model& f, const S& s, Real h) { return Method{}.start(f, s, h); };
            from_two = [](const Model& f, const S& before, const S& s, Real h) {
                return Method{}.step(f, before, s, h);
            };
        } else {
            from_one = [](const Model& f, const S& s, Real h) { return Method{}.step(f, s, h); };
        }
    }

    bool takes_force() const { return from_one != nullptr; }
    void check_step(const Model& f, const S& s, Real h) const {
        if (check) check(f, s, h);
    }
    S start(const Model& f, const S& s, Real h) const { return from_one(f, s, h); }
    S step(const Model& f, const S& before, const S& s, Real h) const {
        return from_two ? from_two(f, before, s, h) : from_one(f, s, h);
    }
};
