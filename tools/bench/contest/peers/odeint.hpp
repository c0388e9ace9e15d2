#pragma once
// Boost.odeint: odeint.cpp says for which forces.

#include "../contest.hpp"

namespace contest::odeint {

template <class Model, class S>
void enter(Scene& scene, const Model& model, const S& start);

}  // namespace contest::odeint
