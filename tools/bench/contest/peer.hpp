#pragma once
// A solver of another library as an entry.

#include <memory>
#include <string>
#include <vector>

#include "counted.hpp"
#include "flat.hpp"
#include "runner.hpp"

namespace contest {

// What a method that chooses its steps itself may do wrong in one of them, as a share of the
// scene's size: so many metres in a position, and as many metres a second in a velocity.
inline double tolerance(long steps) {
    const double share = double(marks) / double(steps);
    return share * share;
}

// A solver and its problem, in steps of one length.
class Solver : public Runner {
public:
    Solver() = default;
    Solver(const Solver&) = delete;

    // `twin` is the same solver, on a model that counts in `asked`.
    void count_by(std::unique_ptr<Solver> twin, std::shared_ptr<Work> asked, int coordinates) {
        twin_ = std::move(twin), asked_ = std::move(asked), coordinates_ = coordinates;
    }
    Place place() const override { return {numbers(), numbers() + coordinates_}; }
    double number() const override { return numbers()[0]; }
    Work work(long steps) override {
        *asked_ = {};
        twin_->restart(steps);
        twin_->advance(adaptive() ? marks : steps);
        return {adaptive() ? twin_->steps_taken() : steps, asked_->evaluations, twin_->solves()};
    }

protected:
    virtual const double* numbers() const = 0;  // the coordinates first
    // Since the start. Only an adaptive solver counts its steps.
    virtual long steps_taken() const { return 0; }
    virtual long solves() const { return 0; }

private:
    std::unique_ptr<Solver> twin_;
    std::shared_ptr<Work> asked_;
    int coordinates_ = 0;
};

// A solver that chooses its steps.
class AdaptiveSolver : public Solver {
public:
    bool adaptive() const override { return true; }
    void restart(long steps) override { mark_ = 0, begin(steps); }
    void advance(long n) override {
        for (const long last = mark_ + n; mark_ < last;) go_to(duration * double(++mark_) / marks);
    }

protected:
    virtual void begin(long steps) = 0;
    virtual void go_to(double time) = 0;

private:
    long mark_ = 0;
};

// What a library has for a problem.
struct Method {
    const char* name;
    std::unique_ptr<Solver> solver;
};
using Methods = std::vector<Method>;

// A model, and how often it was asked.
template <class Model>
struct Tally {
    Model model;
    Work asked = {};
    Counted<Model> counted{&model, &asked};
};

// Enters the methods that `methods(model)` makes. (Making a solver is not timed: memory is asked for once.)
template <class X, class Model, class Make>
void enter(Scene& scene, const std::string& library, const Model& model, const Make& methods) {
    const std::shared_ptr<Tally<Model>> tally(new Tally<Model>{model});
    const std::shared_ptr<Work> asked(tally, &tally->asked);  // keeps all of the tally
    Methods timed = methods(model), counting = methods(tally->counted);
    for (std::size_t i = 0; i < timed.size(); ++i) {
        timed[i].solver->count_by(std::move(counting[i].solver), asked, size_of<X>());
        scene.entries.push_back(make_entry(timed[i].name, library, std::move(timed[i].solver)));
    }
}

}  // namespace contest
