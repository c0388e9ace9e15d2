// A guard instead of #pragma once: compilers complain of that where a header is compiled
// beforehand.
#ifndef TIMESTEP_EXERCISE_HPP
#define TIMESTEP_EXERCISE_HPP
/// \file
/// What an exercise gives to the file you write: the usual standard headers, the course's states,
/// and `not_started`.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <timestep/state.hpp>

using timestep::State;

namespace exercise {

/// Thrown where an answer has not been written yet.
struct NotStarted {};

/// Stands for an answer of any type until you write yours.
struct Placeholder {
    template <class T>
    operator T() const {
        throw NotStarted{};
    }
};

}  // namespace exercise

/// Replace `return not_started;` by your answer.
inline constexpr exercise::Placeholder not_started;

#endif
