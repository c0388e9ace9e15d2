// Solvers of other libraries as entries: what all of them share.

#include "peers/peer.hpp"

namespace contest {

namespace {

Entry entry(const std::string& method, const std::string& library, int coordinates,
            const std::shared_ptr<Solver>& solver, const std::shared_ptr<Solver>& counting,
            const std::shared_ptr<Work>& asked) {
    const bool adaptive = solver->adaptive;
    Entry e{method, library, {}, {}, {}, adaptive};
    e.track = [=](long steps) {
        Track track;
        solver->restart(steps);
        for (int mark = 0; mark < marks; ++mark) {
            solver->advance(adaptive ? 1 : steps / marks);
            track.emplace_back(solver->place(), solver->place() + coordinates);
        }
        return track;
    };
    e.run = [=](long steps) {
        solver->restart(steps);
        solver->advance(adaptive ? marks : steps);
        sink = solver->place()[0];
    };
    e.work = [=](long steps) {
        *asked = {};
        counting->restart(steps);
        counting->advance(adaptive ? marks : steps);
        return Work{adaptive ? counting->steps_taken() : steps, asked->evaluations, counting->solves()};
    };
    return e;
}

}  // namespace

void enter(Scene& scene, const std::string& library, int coordinates, Methods timed, Methods counting,
           const std::shared_ptr<Work>& asked) {
    for (std::size_t i = 0; i < timed.size(); ++i)
        scene.entries.push_back(entry(timed[i].name, library, coordinates, std::move(timed[i].solver),
                                      std::move(counting[i].solver), asked));
}

}  // namespace contest
