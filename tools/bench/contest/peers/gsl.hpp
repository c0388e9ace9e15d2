#pragma once
// The GNU Scientific Library calls a force through a pointer to a function and passes it a pointer to the model, so its
// solvers are compiled once for all forces.

#include "peer.hpp"

namespace contest::gsl {

struct Problem {
    int (*slope)(double t, const double* y, double* dydt, void* model);
    std::shared_ptr<void> model;
    std::vector<double> start;
    double size;  // of the scene
};

Methods methods(const Problem&);  // gsl.cpp

template <class X, class Model>
int slope_of(double, const double* y, double* dydt, void* model) {
    slope<X>(*static_cast<const Model*>(model), y, dydt);
    return 0;  // GSL_SUCCESS
}

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    contest::enter<X>(scene, "GSL", model, [&]<class M>(const M& m) {
        return methods({slope_of<X, M>, std::shared_ptr<M>(new M(m)), flat(start), scene.size});
    });
}

}  // namespace contest::gsl
