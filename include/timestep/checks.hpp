#pragma once
/// \file
/// Inputs are checked once, when models and runs are made, so that a step stays a bare formula.
/// Each check returns the value it was given, or refuses (refuse.hpp: throws
/// `std::invalid_argument`) with one line that names the value and the rule that it breaks.

#include <cmath>
#include <cstdio>
#include <limits>
#include <type_traits>

#include <timestep/refuse.hpp>
#include <timestep/state.hpp>

namespace timestep {

/// Refuses: "name = value: must be rule".
template <class Real>
[[noreturn]] void refuse(const char* name, Real value, const char* rule) {
#if defined(TIMESTEP_REFUSED_BRIEFLY)
    static_cast<void>(name), static_cast<void>(value);
    refuse(rule);
#else
    char line[256];  // no allocation
    std::snprintf(line, sizeof line, "%s = %g: must be %s", name, static_cast<double>(value), rule);
    refuse(line);
#endif
}

/// \cond
namespace detail {
template <class Real>
constexpr bool is_finite_parameter(Real value) {
    static_assert(!std::is_integral_v<Real>,
                  "timestep: parameters are real numbers: write 1.0 instead of 1");
    // As std::isfinite, which is constexpr only from C++23 on.
    return std::numeric_limits<Real>::lowest() <= value &&
           value <= std::numeric_limits<Real>::max();
}

// Refuses the first number, of one or of a pack, for which `holds` is false.
template <class Real, class Holds>
constexpr const Real& ask(const char* name, const Real& value, const char* rule,
                          const Holds& holds) {
    for_each_number(
        [&](auto number) {
            if (!(is_finite_parameter(number) && holds(number))) refuse(name, number, rule);
        },
        value);
    return value;
}
}  // namespace detail
/// \endcond

/// Returns `value` if it is a finite number; refuses any other.
template <class Real>
constexpr Real finite(const char* name, Real value) {
    return detail::ask(name, value, "a finite number", [](auto) { return true; });
}

/// Returns `value` if it is finite and above zero; refuses any other.
template <class Real>
constexpr Real positive(const char* name, Real value) {
    return detail::ask(name, value, "finite and greater than zero", [](auto x) { return x > 0; });
}

/// Returns `value` if it is finite and zero or more; refuses any other.
template <class Real>
constexpr Real not_negative(const char* name, Real value) {
    return detail::ask(name, value, "finite and zero or more", [](auto x) { return x >= 0; });
}

/// Whether every part of a number or a vector is a finite number.
template <class X>
[[nodiscard]] bool is_finite(const X& x) {
    static_assert(
        is_number<X> || requires { x.rows(), x.cols(); },
        "timestep: write `bool is_finite(const Vec3&)` beside a vector of your own");
    if constexpr (std::is_arithmetic_v<X>) {
        return detail::is_finite_parameter(x);
    } else if constexpr (is_number<X>) {
        bool all = true;
        for_each_number([&](auto number) { all = all && std::isfinite(number); }, x);
        return all;
    } else if constexpr (requires { x.rows(), x.cols(); }) {
        bool all = true;
        for (int j = 0; j < x.cols(); ++j)
            for (int i = 0; i < x.rows(); ++i) all = all && is_finite(x(i, j));
        return all;
    }
}
/// Whether time, position and velocity are finite.
template <class X>
[[nodiscard]] bool is_finite(const State<X>& s) {
    return is_finite(s.t) && is_finite(s.x) && is_finite(s.v);
}
/// Whether time and every unknown are finite.
template <class Y>
[[nodiscard]] bool is_finite(const FirstOrder<Y>& s) {
    return is_finite(s.t) && is_finite(s.y);
}

}  // namespace timestep
