#pragma once
// SUNDIALS: Runge-Kutta 4 by ARKODE, multistep methods by CVODE. They call a force through a pointer to a function and
// pass it a pointer to the model, so they are compiled once for all forces.

#include <nvector/nvector_serial.h>
#include <sunmatrix/sunmatrix_dense.h>

#include "peer.hpp"

namespace contest::sundials {

struct Problem {
    int (*f)(double t, N_Vector y, N_Vector dydt, void* model);
    int (*slopes)(double t, N_Vector y, N_Vector dydt, SUNMatrix matrix, void* model, N_Vector, N_Vector,
                  N_Vector);  // ∂ẏ/∂y, or nullptr
    std::shared_ptr<void> model;
    std::vector<double> start;
    double size;  // of the scene
};

Methods methods(const Problem&);  // sundials.cpp

template <class X, class Model>
Problem problem(const Model& model, const timestep::State<X>& start, double size) {
    Problem problem{nullptr, nullptr, std::shared_ptr<Model>(new Model(model)), flat(start), size};
    problem.f = [](double, N_Vector y, N_Vector dydt, void* model) -> int {
        slope<X>(*static_cast<const Model*>(model), N_VGetArrayPointer(y), N_VGetArrayPointer(dydt));
        return 0;
    };
    if constexpr (timestep::SmoothForce<Model, X>)
        problem.slopes = [](double, N_Vector y, N_Vector, SUNMatrix matrix, void* model, N_Vector, N_Vector,
                            N_Vector) -> int {
            jacobian<X>(*static_cast<const Model*>(model), N_VGetArrayPointer(y),
                        [&](int i, int j, double value) { SM_ELEMENT_D(matrix, i, j) = value; });
            return 0;
        };
    return problem;
}

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    contest::enter<X>(scene, "SUNDIALS", model, [&](const auto& m) { return methods(problem(m, start, scene.size)); });
}

}  // namespace contest::sundials
