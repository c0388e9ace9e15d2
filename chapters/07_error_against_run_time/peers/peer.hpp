#pragma once
// A solver of another library as an entry.

#include <memory>

#include "../entries.hpp"
#include "flat.hpp"

namespace contest {

// What a method that chooses its steps itself may do wrong in one of them, as a share of the
// scene's size: so many metres in a position, and as many metres a second in a velocity.
inline double tolerance(long steps) {
    const double share = double(marks) / double(steps);
    return share * share;
}

// `set_up(model)` makes the solver. That is not timed: memory is asked for once. What it makes has
//
//     long run(steps, observe)
//
// which starts anew, shows `observe` where things are (a pointer to the coordinates) after each
// step, or at each mark if it is adaptive, and returns how many steps it took.
template <class X, class Model, class SetUp>
Entry peer(const std::string& method, const std::string& library, const Model& model,
           const SetUp& set_up) {
    using Solver = decltype(set_up(model));
    const std::shared_ptr<Solver> solver(new Solver(set_up(model)));
    Entry e{method, library, {}, {}, {}, Solver::adaptive};
    e.track = [solver](long steps) {
        Track track;
        const long every = Solver::adaptive ? 1 : steps / marks;
        long seen = 0;
        solver->run(steps, [&](const double* x) {
            if (++seen % every == 0) track.emplace_back(x, x + size_of<X>());
        });
        return track;
    };
    e.run = [solver](long steps) { solver->run(steps, [](const double*) {}); };
    e.work = [model, set_up](long steps) {
        Work work;
        auto counted = set_up(Counted<Model>{&model, &work});
        work.steps = counted.run(steps, [](const double*) {});
        if constexpr (requires { counted.solves(); }) work.solves = counted.solves();
        return work;
    };
    return e;
}

}  // namespace contest
