#pragma once
// The chapter's methods, one after the other, each as a step of the whole body.

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <type_traits>

#include <timestep/gyroscopic.hpp>
#include <timestep/gyroscopic/cayley_gyroscopic.hpp>
#include <timestep/gyroscopic/half_step_jacobian.hpp>
#include <timestep/methods/runge_kutta_4.hpp>
#include <timestep/rigid/exact_free_body.hpp>
#include <timestep/rigid/free_body.hpp>
#include <timestep/rigid/strang.hpp>
#include <timestep/rigid/symmetric_remainder.hpp>
#include <timestep/rigid/tumble.hpp>

#include "appendix/others.hpp"

using Vector = timestep::Vector3<double>;
using Body = timestep::PrincipalInertia<double>;
using Spin = timestep::SpinState<double>;

// Runge-Kutta 4, which knows nothing of rotations; after each step its quaternion is scaled back.
struct RungeKuttaSpin {
    static constexpr const char* name = "Runge-Kutta 4";
    static constexpr int order = 4;

    TIMESTEP_INLINE Spin step(const Body& inertia, const Spin& s, double h) const {
        using Model = timestep::FreeBody<Body>;
        Model::Y y;
        y << s.q.coeffs(), s.omega;
        const timestep::FirstOrder<Model::Y> now{s.t, y};
        const auto next = timestep::runge_kutta_4.step(Model(inertia), now, h);
        const timestep::Quaternion<double> q(Eigen::Vector4d(next.y.head<4>()));
        return {next.t, q.normalized(), next.y.tail<3>()};
    }
};

// The name of a method in data files and figures.
template <class Method>
const char* key(const Method&) {
    using namespace timestep;
    if constexpr (std::is_same_v<Method, Tumble<ImplicitGyroscopic>>) return "implicit";
    if constexpr (std::is_same_v<Method, Tumble<PassiveGyroscopic>>) return "passive";
    if constexpr (std::is_same_v<Method, Tumble<HalfStepJacobian>>) return "half_step";
    if constexpr (std::is_same_v<Method, Tumble<CayleyGyroscopic>>) return "cayley";
    if constexpr (std::is_same_v<Method, Strang>) return "strang";
    if constexpr (std::is_same_v<Method, SymmetricRemainder2>) return "remainder_2";
    if constexpr (std::is_same_v<Method, SymmetricRemainder4>) return "remainder_4";
    if constexpr (std::is_same_v<Method, RungeKuttaSpin>) return "runge_kutta_4";
    if constexpr (std::is_same_v<Method, MagnusTaylor>) return "magnus";
    if constexpr (std::is_same_v<Method, MidpointSpin>) return "midpoint";
    return "other";
}

// Its name in tables and in what the program prints.
template <class Method>
std::string name_of(const Method& method) {
    const bool talk = std::is_same_v<Method, timestep::Tumble<timestep::ImplicitGyroscopic>>;
    return talk ? "talk" : method.name;
}

// Calls visit(method) for each of the chapter's line.
template <class Visit>
void for_each_method(const Visit& visit) {
    using namespace timestep;
    std::apply([&](const auto&... method) { (visit(method), ...); },
               std::tuple{tumble<ImplicitGyroscopic>, tumble<PassiveGyroscopic>,
                          tumble<HalfStepJacobian>, tumble<CayleyGyroscopic>, strang,
                          symmetric_remainder_2, symmetric_remainder_4, RungeKuttaSpin{}});
}

// What a method asks for of a body, made once: the remainder methods split it beforehand.
template <class Method>
auto prepared(const Method&, const Body& inertia) {
    using namespace timestep;
    if constexpr (std::is_same_v<Method, SymmetricRemainder2> ||
                  std::is_same_v<Method, SymmetricRemainder4>)
        return RemainderInertia<double>(inertia);
    else
        return inertia;
}

inline Spin spinning(const Vector& omega) {
    return {0, timestep::Quaternion<double>::Identity(), omega};
}

// The exact motion, in body coordinates.
class Exact {
public:
    Exact(const Body& inertia, const Spin& start) : motion_(inertia, in_world(start)) {}
    Spin operator()(double t) const { return in_body(motion_(t)); }

private:
    timestep::ExactFreeBody<double> motion_;
};

// The larger one; and where a value is no number, that stays to be seen as ∞.
inline double larger(double most, double value) {
    return value <= most ? most : std::isnan(value) ? INFINITY : value;
}

// Of two attitudes an angle α apart 2 sin(α/2): the angle in radians while it is small, at most 2.
inline double apart(const timestep::Quaternion<double>& p, const timestep::Quaternion<double>& q) {
    return 2 * std::min(1.0, (p.conjugate() * q).vec().norm());
}
