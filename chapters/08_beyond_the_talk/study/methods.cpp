// Every method of the chapter and of its appendix, compiled once.

#include "methods.hpp"

#include <stdexcept>

#include <timestep/body_solvers.hpp>
#include <timestep/body_throw.hpp>

#include "engines/rules.hpp"
#include "lab.hpp"

using namespace timestep;

namespace {

template <class Rule>
Method made(const Rule& rule, const std::string& name, const std::string& key) {
    const auto of_body = [=](const Body& inertia) -> Steps {
        const auto body = timestep::detail::prepared(rule, inertia);
        return [=, rule = rule](Spin s, double h,
                                long steps) mutable {  // one remembers its last slope
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
    static const std::vector<Method> all{made(tumble<ImplicitGyroscopic>, "one Newton step", "implicit"),
                                         made(tumble<PassiveGyroscopic>, "passive"),
                                         made(tumble<HalfStepJacobian>, "half_step"),
                                         made(tumble<CalmHalfStep>, "calm"),
                                         made(tumble<CayleyGyroscopic>, "cayley"),
                                         made(strang, "strang"),
                                         made(ball_and_remainder_2, "remainder_2"),
                                         made(ball_and_remainder_4, "remainder_4"),
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

const Method& method(std::string_view key) {
    for (const auto* all : {&methods(), &others()})
        for (const Method& one : *all)
            if (one.key == key) return one;
    throw std::logic_error("chapter 8 has no method " + std::string(key));
}

Exact::Exact(const Body& inertia, const Spin& start)
    : motion_([motion = ExactFreeBody<double>(inertia, in_world(start))](double t) { return in_body(motion(t)); }) {}
