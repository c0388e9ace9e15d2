#pragma once
// What theory knows of a method, and the method's steps on the forces of the extreme scenes.

#include <cmath>
#include <limits>
#include <stdexcept>
#include <tuple>

#include <Eigen/Core>

#include <timestep/models/coupled_springs.hpp>
#include <timestep/models/damped_spring.hpp>
#include <timestep/models/decay.hpp>
#include <timestep/models/drag.hpp>
#include <timestep/models/pendulum.hpp>
#include <timestep/models/projectile.hpp>
#include <timestep/models/spring.hpp>
#include <timestep/models/tether.hpp>
#include <timestep/scene.hpp>
#include <timestep/stability.hpp>
#include <timestep/stability_function.hpp>
#include <timestep/stability_limit.hpp>

#include "../any_method.hpp"
#include "extremes.hpp"

namespace extremes {

// By how much a step of ωh = s multiplies in the long run. Plain Verlet goes through the positions
// of velocity Verlet; BDF2 never grows, and is never asked.
template <class Method>
long double growth(long double zeta, long double s) {
    if constexpr (std::is_same_v<Method, Verlet>)
        return growth<VelocityVerlet>(zeta, s);
    else if constexpr (std::is_same_v<Method, Bdf2>)
        return 1;
    else if constexpr (takes<Method, DampedSpring<long double>, State<long double>>())
        return spectral_radius(step_matrix(Method{}, DampedSpring<long double>(1, zeta), s));
    else
        return spectral_radius(step_matrix(Method{}, Spring<long double>(1), s));
}

// What is known of a method, whatever it steps.
struct Known {
    bool is_implicit, is_midpoint;  // the second: implicit midpoint
    double (*limit)(double zeta);
    long double (*growth)(long double zeta, long double s);
    Complex (*factor)(Complex z);  // R(z), null where there is none

    template <class Method>
    explicit Known(const Method&)
        : is_implicit(std::is_same_v<Method, ImplicitEuler> || std::is_same_v<Method, Bdf2> ||
                      std::is_same_v<Method, ImplicitMidpoint>),
          is_midpoint(std::is_same_v<Method, ImplicitMidpoint>),
          limit([](double zeta) { return stability_limit(Method{}, zeta).value; }),
          growth(extremes::growth<Method>),
          factor(nullptr) {
        if constexpr (HasStabilityFunction<Method>) factor = [](Complex z) { return stability_function(Method{}, z); };
    }
};

// A method as the scenes see it: what is known, and its steps on every force.
template <class Real>
struct ExtremeMethod : Known {
    using Plane = Eigen::Matrix<Real, 2, 1>;
    template <class Model, class X = Real>
    using On = AnyMethod<Model, State<X>>;

    const char* name;
    std::tuple<On<Spring<Real>>, On<DampedSpring<Real>>, On<Projectile<Real>>, On<Drag<Real>>, On<Pendulum<Real>>,
               On<Scene<Spring<Real>, Projectile<Real>>>, On<CoupledSprings<Real, 2>, Plane>, On<Tether<Real>, Plane>,
               AnyMethod<Decay<Real>, FirstOrder<Real>>>
        steps;

    template <class Method>
    explicit ExtremeMethod(const Method& m) : Known(m), name(m.name), steps(m, m, m, m, m, m, m, m, m) {}

    template <class Model, class S>
    const AnyMethod<Model, S>& on() const {
        return std::get<AnyMethod<Model, S>>(steps);
    }
};

// A spring, or several of which the fastest has this ω: the longest stable step decides, and beyond
// it the larger eigenvalue. A stable state may swell before it settles: the ellipses that it goes
// round have axes in a ratio of 3.4 at the most, here at ωh = 5/3; 8 leaves room for a start off
// both axes.
template <class Real>
Theory spring_theory(const Known& method, double omega, double zeta, double h, long steps) {
    const double s = omega * h;
    if (s <= method.limit(zeta)) return {Outcome::bounded, 8};
    const double log_step = static_cast<double>(std::log(method.growth(zeta, s)));
    const double log_largest = std::log(static_cast<double>(std::numeric_limits<Real>::max()));
    const double log_last = log_step * steps;
    if (log_last + std::log(8 * std::max(1.0, omega)) < log_largest) return {Outcome::grows, 0, log_last};
    if (log_last < log_largest * 1.01 + 3 * log_step) throw std::logic_error("extremes: take more steps");
    Theory theory{Outcome::reported, 0, 0, log_largest * 1.01 / log_step + 3};
    theory.earliest = (log_largest - std::log(8 * std::max(1.0, omega))) * 0.99 / log_step - 3;
    return theory;
}

}  // namespace extremes
