// Rigid bodies as entries: what all of them share.

#include "bodies.hpp"

namespace contest {

Entry stepped(const std::string& method, const std::string& library, std::unique_ptr<Runner> its_runner) {
    const std::shared_ptr<Runner> runner = std::move(its_runner);
    const auto h = [](long steps) { return duration / double(steps); };
    Entry e{method, library, {}, {}, {}};
    e.track = [=](long steps) {
        Track track;
        runner->restart();
        for (int mark = 0; mark < marks; ++mark) {
            runner->advance(h(steps), steps / marks);
            track.push_back(runner->place());
        }
        return track;
    };
    e.run = [=](long steps) {
        runner->restart();
        runner->advance(h(steps), steps);
        sink = runner->number();
    };
    e.work = [=](long steps) {
        Work work;
        runner->restart();
        for (; work.steps < steps; ++work.steps) {
            runner->count(work, h(steps));
            runner->advance(h(steps), 1);
        }
        return work;
    };
    return e;
}

}  // namespace contest
