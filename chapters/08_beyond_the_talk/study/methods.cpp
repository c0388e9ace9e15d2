// Every method of the chapter and of its appendix, compiled once.

#include "methods.hpp"

#include <stdexcept>
#include <type_traits>

#include <timestep/gyroscopic/calm_half_step.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/gyroscopic/implicit_gyroscopic.hpp>
#include <timestep/gyroscopic/passive_gyroscopic.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/strang.hpp>
#include <timestep/rigid/symmetric_remainder.hpp>
#include <timestep/rigid/tumble.hpp>

#include "appendix/others.hpp"
#include "lab.hpp"

using namespace timestep;

namespace {

// Runge-Kutta 4, which knows nothing of rotations; after each step its quaternion is scaled back.
struct RungeKuttaSpin {
    static constexpr const char* name = "Runge-Kutta 4";
    static constexpr int order = 4;

    TIMESTEP_INLINE Spin step(const Body& inertia, const Spin& s, double h) const {
        using Model = FreeBody<Body>;
        Model::Y y;
        y << s.q.coeffs(), s.omega;
        const FirstOrder<Model::Y> now{s.t, y};
        const auto next = runge_kutta_4.step(Model(inertia), now, h);
        const Quaternion<double> q(Eigen::Vector4d(next.y.head<4>()));
        return {next.t, q.normalized(), next.y.tail<3>()};
    }
};

// What a method asks for of a body, made once: the remainder methods split it beforehand.
template <class Rule>
auto prepared(const Rule&, const Body& inertia) {
    if constexpr (std::is_same_v<Rule, SymmetricRemainder2> ||
                  std::is_same_v<Rule, SymmetricRemainder4>)
        return RemainderInertia<double>(inertia);
    else
        return inertia;
}

template <class Rule>
Method made(const Rule& rule, const std::string& name, const std::string& key) {
    const auto of_body = [=](const Body& inertia) -> Steps {
        const auto body = prepared(rule, inertia);
        return [=](Spin s, double h, long steps) {
            for (long n = 0; n < steps; ++n) s = rule.step(body, s, h);
            return s;
        };
    };
    return {name, key, rule.order, of_body};
}
template <class Rule>
Method made(const Rule& rule, const std::string& key) {
    return made(rule, rule.name, key);
}

}  // namespace

const std::vector<Method>& methods() {
    static const std::vector<Method> all{made(tumble<ImplicitGyroscopic>, "talk", "implicit"),
                                         made(tumble<PassiveGyroscopic>, "passive"),
                                         made(tumble<HalfStepJacobian>, "half_step"),
                                         made(tumble<CalmHalfStep>, "calm"),
                                         made(tumble<CayleyGyroscopic>, "cayley"),
                                         made(strang, "strang"),
                                         made(symmetric_remainder_2, "remainder_2"),
                                         made(symmetric_remainder_4, "remainder_4"),
                                         made(RungeKuttaSpin{}, "runge_kutta_4")};
    return all;
}

const std::vector<Method>& engines() {
    static const std::vector<Method> all = [] {
        std::vector<Method> rules;
        for_each_engine([&](const auto& rule) { rules.push_back(made(rule, lab::id(rule.name))); });
        return rules;
    }();
    return all;
}

const std::vector<Method>& others() {
    static const std::vector<Method> all = [] {
        std::vector<Method> rules;
        for_each_book([&](const auto& rule) { rules.push_back(made(rule, lab::id(rule.name))); });
        for (const Method& rule : engines()) rules.push_back(rule);
        return rules;
    }();
    return all;
}

const Method& method(const std::string& key) {
    for (const auto* all : {&methods(), &others()})
        for (const Method& one : *all)
            if (one.key == key) return one;
    throw std::logic_error("chapter 8 has no method " + key);
}

Exact::Exact(const Body& inertia, const Spin& start)
    : motion_([motion = ExactFreeBody<double>(inertia, in_world(start))](double t) {
          return in_body(motion(t));
      }) {}
