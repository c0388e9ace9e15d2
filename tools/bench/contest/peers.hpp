#pragma once
// Other libraries as entries, each where CMake has found it. A method that the course has, too, has the same name.

#include "contest.hpp"

#ifdef TIMESTEP_WITH_ODEINT
#include "peers/odeint.hpp"
#endif
#ifdef TIMESTEP_WITH_GSL
#include "peers/gsl.hpp"
#endif
#ifdef TIMESTEP_WITH_SUNDIALS
#include "peers/sundials.hpp"
#endif

namespace contest {

// A few methods of each library: those that the course has, too, and those that the library recommends.
template <class Model, class S>
void enter_peers([[maybe_unused]] Scene& scene, [[maybe_unused]] const Model& model, [[maybe_unused]] const S& start) {
#ifdef TIMESTEP_WITH_ODEINT
    odeint::enter(scene, model, start);
#endif
#ifdef TIMESTEP_WITH_GSL
    gsl::enter(scene, model, start);
#endif
#ifdef TIMESTEP_WITH_SUNDIALS
    sundials::enter(scene, model, start);
#endif
}

}  // namespace contest
