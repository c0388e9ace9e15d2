#pragma once
// SUNDIALS: Runge and Kutta's method by ARKODE, multistep methods by CVODE.

#include <algorithm>
#include <limits>

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "peer.hpp"

namespace contest::sundials {

// What both solvers need: the force, and a vector of theirs.
template <class Model, class X>
class Problem {
public:
    static constexpr int unknowns = 2 * size_of<X>();

    Problem(const Model& model, const timestep::State<X>& start) : model_(model), start_(start) {
        SUNContext_Create(0, &context_);  // no MPI
        y_ = N_VNew_Serial(unknowns, context_);
        to_start();
    }
    Problem(const Problem&) = delete;  // the solver knows where the problem is
    ~Problem() {
        N_VDestroy(y_);
        SUNContext_Free(&context_);
    }

    SUNContext context() { return context_; }
    N_Vector y() { return y_; }
    double* numbers() { return N_VGetArrayPointer(y_); }
    void to_start() { write(start_, numbers()); }
    void give_up() { std::fill_n(numbers(), unknowns, std::numeric_limits<double>::quiet_NaN()); }

    static int f(double, N_Vector y, N_Vector dydt, void* problem) {
        slope<X>(static_cast<Problem*>(problem)->model_, N_VGetArrayPointer(y),
                 N_VGetArrayPointer(dydt));
        return 0;
    }
    static int slopes(double, N_Vector y, N_Vector, SUNMatrix matrix, void* problem, N_Vector,
                      N_Vector, N_Vector) {
        jacobian<X>(static_cast<Problem*>(problem)->model_, N_VGetArrayPointer(y),
                    [&](int i, int j, double value) { SM_ELEMENT_D(matrix, i, j) = value; });
        return 0;
    }

private:
    Model model_;
    timestep::State<X> start_;
    SUNContext context_ = nullptr;
    N_Vector y_ = nullptr;
};

// A run that has blown up is no error here: nothing is printed.
inline void silent(int, const char*, const char*, char*, void*) {}

// ARKODE steps any table of Runge and Kutta's kind. This is the classical one, without an estimate
// of the error, and with a fifth stage of weight zero: the force at the end of the step, which it
// keeps for the next one. Some of its releases (6.4 among them) take the fourth stage for that
// where there is no fifth, as it stands at the end of the step, too: then they are of order three.
template <class Model, class X>
class RungeKutta4 {
public:
    static constexpr bool adaptive = false;

    RungeKutta4(const Model& model, const timestep::State<X>& start) : problem_(model, start) {
        constexpr double third = 1.0 / 3, sixth = 1.0 / 6;
        double c[] = {0, 0.5, 0.5, 1, 1};
        double a[] = {0,     0,     0,     0,     0,  //
                      0.5,   0,     0,     0,     0,  //
                      0,     0.5,   0,     0,     0,  //
                      0,     0,     1,     0,     0,  //
                      sixth, third, third, sixth, 0};
        double b[] = {sixth, third, third, sixth, 0};
        solver_ = ERKStepCreate(Problem<Model, X>::f, 0, problem_.y(), problem_.context());
        const ARKodeButcherTable table = ARKodeButcherTable_Create(5, 4, 0, c, a, b, nullptr);
        ERKStepSetTable(solver_, table);
        ARKodeButcherTable_Free(table);
        ERKStepSetUserData(solver_, &problem_);
        ERKStepSetErrHandlerFn(solver_, silent, nullptr);
    }
    RungeKutta4(const RungeKutta4&) = delete;
    ~RungeKutta4() { ERKStepFree(&solver_); }

    template <class Observe>
    long run(long steps, const Observe& observe) {
        problem_.to_start();
        ERKStepReInit(solver_, Problem<Model, X>::f, 0, problem_.y());
        ERKStepSetFixedStep(solver_, duration / double(steps));
        double t = 0;
        int status = 0;
        for (long i = 0; i < steps; ++i) {
            if (status >= 0)
                status = ERKStepEvolve(solver_, duration, problem_.y(), &t, ARK_ONE_STEP);
            if (status < 0) problem_.give_up();
            observe(problem_.numbers());
        }
        sink = problem_.numbers()[0];
        return steps;
    }

private:
    Problem<Model, X> problem_;
    void* solver_ = nullptr;
};

// CVODE chooses order and step, and at a mark reads its polynomial: Adams' methods up to order 12,
// each step iterated as it stands; or backward differences (BDF) up to order 5, by Newton's
// iteration with the force's slopes.
template <class Model, class X>
class Multistep {
public:
    static constexpr bool adaptive = true;

    Multistep(const Model& model, const timestep::State<X>& start, double size, int kind)
        : problem_(model, start), size_(size), solver_(CVodeCreate(kind, problem_.context())) {
        CVodeInit(solver_, Problem<Model, X>::f, 0, problem_.y());
        CVodeSetUserData(solver_, &problem_);
        CVodeSetErrHandlerFn(solver_, silent, nullptr);
        CVodeSetMaxNumSteps(solver_, -1);  // as many as it takes
        if (kind == CV_ADAMS) {
            iteration_ = SUNNonlinSol_FixedPoint(problem_.y(), 0, problem_.context());
            CVodeSetNonlinearSolver(solver_, iteration_);
        } else {
            const int n = Problem<Model, X>::unknowns;
            matrix_ = SUNDenseMatrix(n, n, problem_.context());
            linear_ = SUNLinSol_Dense(problem_.y(), matrix_, problem_.context());
            CVodeSetLinearSolver(solver_, linear_, matrix_);
            CVodeSetJacFn(solver_, Problem<Model, X>::slopes);
        }
    }
    Multistep(const Multistep&) = delete;
    ~Multistep() {
        CVodeFree(&solver_);
        if (iteration_) SUNNonlinSolFree(iteration_);
        if (linear_) SUNLinSolFree(linear_);
        if (matrix_) SUNMatDestroy(matrix_);
    }

    template <class Observe>
    long run(long steps, const Observe& observe) {
        problem_.to_start();
        CVodeReInit(solver_, 0, problem_.y());
        CVodeSStolerances(solver_, 0, tolerance(steps) * size_);
        double t = 0;
        int status = 0;
        for (int mark = 1; mark <= marks; ++mark) {
            if (status >= 0)
                status = CVode(solver_, duration * mark / marks, problem_.y(), &t, CV_NORMAL);
            if (status < 0) problem_.give_up();
            observe(problem_.numbers());
        }
        sink = problem_.numbers()[0];
        long taken = 0;
        CVodeGetNumSteps(solver_, &taken);
        return taken;
    }

    // Each of Newton's iterations solves a linear system. The matrix is factorised more rarely.
    long solves() const {
        long iterations = 0;
        if (linear_) CVodeGetNumNonlinSolvIters(solver_, &iterations);
        return iterations;
    }

private:
    Problem<Model, X> problem_;
    double size_;
    void* solver_;
    SUNNonlinearSolver iteration_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver linear_ = nullptr;
};

template <class Model, class X>
void enter(Scene& scene, const Model& model, const timestep::State<X>& start) {
    const auto add = [&](const std::string& method, const auto& set_up) {
        scene.entries.push_back(peer<X>(method, "SUNDIALS", model, set_up));
    };
    const auto multistep = [&](const std::string& method, int kind) {
        add(method, [start, kind, size = scene.size](const auto& m) {
            return Multistep<std::decay_t<decltype(m)>, X>(m, start, size, kind);
        });
    };
    add("Runge-Kutta 4",
        [start](const auto& m) { return RungeKutta4<std::decay_t<decltype(m)>, X>(m, start); });
    multistep("Adams, adaptive", CV_ADAMS);
    if constexpr (timestep::SmoothForce<Model, X>) multistep("BDF, adaptive", CV_BDF);
}

}  // namespace contest::sundials
