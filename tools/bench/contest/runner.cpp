#include "runner.hpp"

namespace contest {

Entry make_entry(const std::string& method, const std::string& library, std::unique_ptr<Runner> its_runner) {
    const std::shared_ptr<Runner> runner = std::move(its_runner);
    Entry e{method, library, {}, {}, {}, runner->adaptive()};
    e.track = [=](long steps) {
        const long every = runner->adaptive() ? 1 : steps / marks;
        Track track;
        runner->restart(steps);
        for (long mark = 1; mark <= marks; ++mark) {
            const bool anew = mark > 1 && runner->stuck();
            if (anew) runner->restart(steps);
            runner->advance(anew ? mark * every : every);
            track.push_back(runner->place());
        }
        return track;
    };
    e.run = [=](long steps) {
        runner->restart(steps);
        runner->advance(runner->adaptive() ? marks : steps);
        sink = runner->number();
    };
    e.work = [=](long steps) { return runner->work(steps); };
    return e;
}

}  // namespace contest
