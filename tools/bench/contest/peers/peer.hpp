#pragma once
// A solver of another library as an entry.

#include <memory>
#include <string>
#include <vector>

#include "../counted.hpp"
#include "flat.hpp"

namespace contest {

// What a method that chooses its steps itself may do wrong in one of them, as a share of the
// scene's size: so many metres in a position, and as many metres a second in a velocity.
inline double tolerance(long steps) {
    const double share = double(marks) / double(steps);
    return share * share;
}

// A solver and its problem. One call of `advance` takes a whole run, so the cost of the call does not count.
class Solver {
public:
    explicit Solver(bool is_adaptive) : adaptive(is_adaptive) {}
    Solver(const Solver&) = delete;
    virtual ~Solver() = default;

    const bool adaptive;
    // Back to the start, for a run of so many steps.
    virtual void restart(long steps) = 0;
    // Goes n steps on; an adaptive solver goes n marks on.
    virtual void advance(long n) = 0;
    // The coordinates.
    virtual const double* place() const = 0;
    // Since the start. Only an adaptive solver counts its steps.
    virtual long steps_taken() const { return 0; }
    virtual long solves() const { return 0; }
};

// What a library has for a problem.
struct Method {
    const char* name;
    std::unique_ptr<Solver> solver;
};
using Methods = std::vector<Method>;

// Enters the methods that are timed. (Making a solver is not: memory is asked for once.) `counting`
// are the same, on a model that counts in `asked`.
void enter(Scene& scene, const std::string& library, int coordinates, Methods timed, Methods counting,
           const std::shared_ptr<Work>& asked);  // peers.cpp

// A model, and how often it was asked.
template <class Model>
struct Tally {
    Model model;
    Work asked = {};
    Counted<Model> counted{&model, &asked};
};

// `methods(model)` makes the methods.
template <class X, class Model, class Make>
void enter(Scene& scene, const std::string& library, const Model& model, const Make& methods) {
    const std::shared_ptr<Tally<Model>> tally(new Tally<Model>{model});
    const std::shared_ptr<Work> asked(tally, &tally->asked);  // keeps all of the tally
    enter(scene, library, size_of<X>(), methods(model), methods(tally->counted), asked);
}

}  // namespace contest
