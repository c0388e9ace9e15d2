#pragma once
// The GNU Scientific Library, which reaches a force through a pointer to a function.

#include <limits>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "peer.hpp"

namespace contest::gsl {

template <class Model, class X>
gsl_odeiv2_system system(const Model& model) {
    const auto f = [](double, const double* y, double* dydt, void* model) -> int {
        slope<X>(*static_cast<const Model*>(model), y, dydt);
        return GSL_SUCCESS;
    };
    return {f, nullptr, std::size_t(2 * size_of<X>()), const_cast<Model*>(&model)};
}

// GSL's rk4 is not Runge-Kutta 4 alone. It crosses each step once in one step and once in two half
// steps; it goes on with the latter, and the difference is its estimate of the error. So it ends
// where Runge-Kutta 4 with half the step ends, and asks for the force 11 times a step. Nobody can
// tell it to leave out the estimate.
template <class Model, class X>
class Doubling {
public:
    static constexpr bool adaptive = false;

    Doubling(const Model& model, const timestep::State<X>& start)
        : model_(model),
          start_(start),
          step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, 2 * size_of<X>()),
                gsl_odeiv2_step_free) {}

    template <class Observe>
    long run(long steps, const Observe& observe) {
        const gsl_odeiv2_system f = system<Model, X>(model_);
        const double h = duration / double(steps);
        double t = 0;
        Flat<X> y, error;
        write(start_, y.data());
        gsl_odeiv2_step_reset(step_.get());
        for (long i = 0; i < steps; ++i, t += h) {
            gsl_odeiv2_step_apply(step_.get(), t, h, y.data(), error.data(), nullptr, nullptr, &f);
            observe(y.data());
        }
        sink = y[0];
        return steps;
    }

private:
    Model model_;
    timestep::State<X> start_;
    std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step_;
};

// Prince and Dormand's pair of order eight, with GSL's driver, which ends a step on every mark.
template <class Model, class X>
class Adaptive {
public:
    static constexpr bool adaptive = true;

    Adaptive(const Model& model, const timestep::State<X>& start, double size)
        : model_(model),
          start_(start),
          size_(size),
          system_(system<Model, X>(model_)),
          driver_(gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, 1e-3, 1, 1),
                  gsl_odeiv2_driver_free) {
        gsl_set_error_handler_off();  // it would end the program; we look at what is returned
    }
    Adaptive(const Adaptive&) = delete;  // the driver knows where the system is

    template <class Observe>
    long run(long steps, const Observe& observe) {
        gsl_odeiv2_control_init(driver_->c, tolerance(steps) * size_, 0, 1, 0);
        gsl_odeiv2_driver_reset_hstart(driver_.get(), duration / double(steps));
        double t = 0;
        Flat<X> y;
        write(start_, y.data());
        for (int mark = 1; mark <= marks; ++mark) {
            if (gsl_odeiv2_driver_apply(driver_.get(), &t, duration * mark / marks, y.data()) !=
                GSL_SUCCESS)
                y.fill(std::numeric_limits<double>::quiet_NaN());
            observe(y.data());
        }
        sink = y[0];
        return long(driver_->e->count);
    }

private:
    Model model_;
    timestep::State<X> start_;
    double size_;
    gsl_odeiv2_system system_;
    std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_;
};

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    const auto add = [&](const std::string& method, const auto& set_up) {
        scene.entries.push_back(peer<X>(method, "GSL", model, set_up));
    };
    add("Runge-Kutta 4, doubled",
        [start](const auto& m) { return Doubling<std::decay_t<decltype(m)>, X>(m, start); });
    add("Prince-Dormand 8, adaptive", [start, size = scene.size](const auto& m) {
        return Adaptive<std::decay_t<decltype(m)>, X>(m, start, size);
    });
}

}  // namespace contest::gsl
