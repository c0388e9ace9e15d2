// The GNU Scientific Library's solvers.

#ifdef TIMESTEP_WITH_GSL

#include <algorithm>
#include <limits>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "peers.hpp"

namespace contest::gsl {

namespace {

gsl_odeiv2_system system_of(const Problem<Slope>& problem) {
    return {problem.slope, nullptr, problem.start.size(), problem.model.get()};
}

// GSL's rk4 is more than Runge-Kutta 4. It takes each step once whole and once as two halves; it goes on with the
// halves, and the difference estimates the error. It ends where Runge-Kutta 4 with half the step ends, and evaluates
// the force 11 times per step. The estimate cannot be switched off.
class Doubling : public Solver {
public:
    explicit Doubling(const Problem<Slope>& problem)
        : problem_(problem),
          system_(system_of(problem_)),
          y_(problem_.start),
          error_(y_.size()),
          step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk4, y_.size()), gsl_odeiv2_step_free) {}

    void restart(long steps) override {
        h_ = duration / double(steps), t_ = 0;
        y_ = problem_.start;
        gsl_odeiv2_step_reset(step_.get());
    }
    void advance(long n) override {
        for (long i = 0; i < n; ++i, t_ += h_)
            gsl_odeiv2_step_apply(step_.get(), t_, h_, y_.data(), error_.data(), nullptr, nullptr, &system_);
    }
    const double* numbers() const override { return y_.data(); }

private:
    Problem<Slope> problem_;
    gsl_odeiv2_system system_;
    double t_ = 0, h_ = 0;
    std::vector<double> y_, error_;
    std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step_;
};

// Prince and Dormand's pair of order eight, with GSL's driver, which ends a step on every mark.
class Adaptive : public AdaptiveSolver {
public:
    explicit Adaptive(const Problem<Slope>& problem)
        : problem_(problem),
          system_(system_of(problem_)),
          y_(problem_.start),
          driver_(gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, 1e-3, 1, 1), gsl_odeiv2_driver_free) {
        gsl_set_error_handler_off();  // it would end the program; the status that is returned tells enough
    }

    void begin(long steps) override {
        gsl_odeiv2_control_init(driver_->c, tolerance(steps) * problem_.size, 0, 1, 0);
        gsl_odeiv2_driver_reset_hstart(driver_.get(), duration / double(steps));
        t_ = 0;
        y_ = problem_.start;
    }
    void go_to(double time) override {
        if (gsl_odeiv2_driver_apply(driver_.get(), &t_, time, y_.data()) != GSL_SUCCESS)
            std::fill(y_.begin(), y_.end(), std::numeric_limits<double>::quiet_NaN());
    }
    const double* numbers() const override { return y_.data(); }
    long steps_taken() const override { return long(driver_->e->count); }

private:
    Problem<Slope> problem_;
    gsl_odeiv2_system system_;
    double t_ = 0;
    std::vector<double> y_;
    std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_;
};

}  // namespace

Methods methods(const Problem<Slope>& problem) {
    Methods all;
    all.push_back({"Runge-Kutta 4, doubled", std::make_unique<Doubling>(problem)});
    all.push_back({"Prince-Dormand 8, adaptive", std::make_unique<Adaptive>(problem)});
    return all;
}

}  // namespace contest::gsl

#endif
