#pragma once
// Other libraries as entries, each where CMake has found it. A method that the course has, too, has the same name. GSL
// and SUNDIALS call a force through a pointer to a function and pass it a pointer to the model, so their solvers are
// compiled once for all forces.

#include "peer.hpp"

#ifdef TIMESTEP_WITH_SUNDIALS
#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>
#endif

namespace contest {

namespace odeint {

template <class Model, class S>
void enter(Scene& scene, const Model& model, const S& start);  // odeint.cpp says for which forces

}  // namespace odeint

// What a library solves. `Slope` is the function that it calls for ẏ, and `Jacobian` the one for ∂ẏ/∂y.
template <class Slope, class Jacobian = void*>
struct Problem {
    std::shared_ptr<void> model;
    std::vector<double> start;
    double size;  // of the scene
    Slope slope;
    Jacobian jacobian = nullptr;  // a force that is not smooth has none
};

template <class Model, class X, class Slope, class... Jacobian>
auto problem(const Model& model, const timestep::State<X>& start, double size, Slope slope, Jacobian... jacobian) {
    return Problem<Slope, Jacobian...>{std::make_shared<Model>(model), flat(start), size, slope, jacobian...};
}

#ifdef TIMESTEP_WITH_GSL
namespace gsl {

using Slope = int (*)(double t, const double* y, double* dydt, void* model);

Methods methods(const Problem<Slope>&);  // gsl.cpp

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    contest::enter<X>(scene, "GSL", model, [&]<class M>(const M& m) {
        const Slope f = [](double, const double* y, double* dydt, void* model) -> int {
            slope<X>(*static_cast<const M*>(model), y, dydt);
            return 0;  // GSL_SUCCESS
        };
        return methods(problem(m, start, scene.size, f));
    });
}

}  // namespace gsl
#endif

#ifdef TIMESTEP_WITH_SUNDIALS
namespace sundials {

using Slope = int (*)(double t, N_Vector y, N_Vector dydt, void* model);
using Jacobian = int (*)(double t, N_Vector y, N_Vector dydt, SUNMatrix matrix, void* model, N_Vector, N_Vector,
                         N_Vector);

Methods methods(const Problem<Slope, Jacobian>&);  // sundials.cpp

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    contest::enter<X>(scene, "SUNDIALS", model, [&]<class M>(const M& m) {
        const Slope f = [](double, N_Vector y, N_Vector dydt, void* model) -> int {
            slope<X>(*static_cast<const M*>(model), N_VGetArrayPointer(y), N_VGetArrayPointer(dydt));
            return 0;
        };
        Jacobian slopes = nullptr;
        if constexpr (timestep::SmoothForce<M, X>)
            slopes = [](double, N_Vector y, N_Vector, SUNMatrix matrix, void* model, N_Vector, N_Vector,
                        N_Vector) -> int {
                jacobian<X>(*static_cast<const M*>(model), N_VGetArrayPointer(y),
                            [&](int i, int j, double value) { SM_ELEMENT_D(matrix, i, j) = value; });
                return 0;
            };
        return methods(problem(m, start, scene.size, f, slopes));
    });
}

}  // namespace sundials
#endif

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
