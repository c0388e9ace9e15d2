// SUNDIALS' solvers.

#ifdef TIMESTEP_WITH_SUNDIALS

#include <algorithm>
#include <limits>

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "peers.hpp"

namespace contest::sundials {

namespace {

using Task = Problem<Slope, Jacobian>;

// The problem and SUNDIALS' vector for it, which both solvers need.
class Unknowns {
public:
    explicit Unknowns(const Task& its_task) : task(its_task) {
        SUNContext_Create(0, &context);  // no MPI
        y = N_VNew_Serial(int(task.start.size()), context);
        to_start();
    }
    Unknowns(const Unknowns&) = delete;
    ~Unknowns() {
        N_VDestroy(y);
        SUNContext_Free(&context);
    }

    double* numbers() const { return N_VGetArrayPointer(y); }
    void to_start() { std::copy(task.start.begin(), task.start.end(), numbers()); }
    void give_up() { std::fill_n(numbers(), task.start.size(), std::numeric_limits<double>::quiet_NaN()); }

    const Task task;
    SUNContext context = nullptr;
    N_Vector y = nullptr;
};

// A run may blow up here: SUNDIALS prints nothing about it.
void silent(int, const char*, const char*, char*, void*) {}

// ARKODE steps any Runge-Kutta table. This is the classical one, without an error estimate, and with a fifth stage of
// weight zero: the force at the end of the step, which ARKODE keeps for the next step. Without the fifth stage some of
// its releases (6.4 among them) keep the fourth, which is at the end of the step, too: their order is then three.
class RungeKutta4 : public Solver {
public:
    explicit RungeKutta4(const Task& task) : unknowns_(task) {
        constexpr double third = 1.0 / 3, sixth = 1.0 / 6;
        double c[] = {0, 0.5, 0.5, 1, 1};
        double a[] = {0,     0,     0,     0,     0,  //
                      0.5,   0,     0,     0,     0,  //
                      0,     0.5,   0,     0,     0,  //
                      0,     0,     1,     0,     0,  //
                      sixth, third, third, sixth, 0};
        double b[] = {sixth, third, third, sixth, 0};
        solver_ = ERKStepCreate(task.slope, 0, unknowns_.y, unknowns_.context);
        const ARKodeButcherTable table = ARKodeButcherTable_Create(5, 4, 0, c, a, b, nullptr);
        ERKStepSetTable(solver_, table);
        ARKodeButcherTable_Free(table);
        ERKStepSetUserData(solver_, unknowns_.task.model.get());
        ERKStepSetErrHandlerFn(solver_, silent, nullptr);
    }
    ~RungeKutta4() override { ERKStepFree(&solver_); }

    void restart(long steps) override {
        unknowns_.to_start();
        ERKStepReInit(solver_, unknowns_.task.slope, 0, unknowns_.y);
        ERKStepSetFixedStep(solver_, duration / double(steps));
        status_ = 0;
    }
    void advance(long n) override {
        double t = 0;
        for (long i = 0; i < n; ++i) {
            if (status_ >= 0) status_ = ERKStepEvolve(solver_, duration, unknowns_.y, &t, ARK_ONE_STEP);
            if (status_ < 0) unknowns_.give_up();
        }
    }
    const double* numbers() const override { return unknowns_.numbers(); }

private:
    Unknowns unknowns_;
    void* solver_ = nullptr;
    int status_ = 0;
};

// CVODE chooses order and step, and at a mark evaluates its polynomial: Adams' methods up to order 12 with fixed-point
// iteration, or backward differences (BDF) up to order 5 with Newton's iteration and the force's slopes.
class Multistep : public AdaptiveSolver {
public:
    Multistep(const Task& task, int kind) : unknowns_(task), solver_(CVodeCreate(kind, unknowns_.context)) {
        CVodeInit(solver_, task.slope, 0, unknowns_.y);
        CVodeSetUserData(solver_, unknowns_.task.model.get());
        CVodeSetErrHandlerFn(solver_, silent, nullptr);
        CVodeSetMaxNumSteps(solver_, -1);  // as many as it takes
        if (kind == CV_ADAMS) {
            iteration_ = SUNNonlinSol_FixedPoint(unknowns_.y, 0, unknowns_.context);
            CVodeSetNonlinearSolver(solver_, iteration_);
        } else {
            const int n = int(task.start.size());
            matrix_ = SUNDenseMatrix(n, n, unknowns_.context);
            linear_ = SUNLinSol_Dense(unknowns_.y, matrix_, unknowns_.context);
            CVodeSetLinearSolver(solver_, linear_, matrix_);
            CVodeSetJacFn(solver_, task.jacobian);
        }
    }
    ~Multistep() override {
        CVodeFree(&solver_);
        if (iteration_) SUNNonlinSolFree(iteration_);
        if (linear_) SUNLinSolFree(linear_);
        if (matrix_) SUNMatDestroy(matrix_);
    }

    void begin(long steps) override {
        unknowns_.to_start();
        CVodeReInit(solver_, 0, unknowns_.y);
        CVodeSStolerances(solver_, 0, tolerance(steps) * unknowns_.task.size);
        status_ = 0;
    }
    void go_to(double time) override {
        double t = 0;
        if (status_ >= 0) status_ = CVode(solver_, time, unknowns_.y, &t, CV_NORMAL);
        if (status_ < 0) unknowns_.give_up();
    }
    const double* numbers() const override { return unknowns_.numbers(); }
    long steps_taken() const override {
        long taken = 0;
        CVodeGetNumSteps(solver_, &taken);
        return taken;
    }
    // Each Newton iteration solves a linear system. The matrix is factorised less often.
    long solves() const override {
        long iterations = 0;
        if (linear_) CVodeGetNumNonlinSolvIters(solver_, &iterations);
        return iterations;
    }

private:
    Unknowns unknowns_;
    void* solver_;
    SUNNonlinearSolver iteration_ = nullptr;
    SUNMatrix matrix_ = nullptr;
    SUNLinearSolver linear_ = nullptr;
    int status_ = 0;
};

}  // namespace

Methods methods(const Task& task) {
    Methods all;
    all.push_back({"Runge-Kutta 4", std::make_unique<RungeKutta4>(task)});
    all.push_back({"Adams, adaptive", std::make_unique<Multistep>(task, CV_ADAMS)});
    if (task.jacobian) all.push_back({"BDF, adaptive", std::make_unique<Multistep>(task, CV_BDF)});
    return all;
}

}  // namespace contest::sundials

#endif
