#include "interrupt.hpp"

#include "stop.hpp"

namespace course {

namespace {

const std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
volatile std::sig_atomic_t caught = 0;

extern "C" void remember_signal(int signal) { caught = signal; }

}  // namespace

TidyEnd::TidyEnd() {
    struct sigaction remember {};
    remember.sa_handler = remember_signal;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        // What is ignored stays ignored: nohup, or a script that runs us beside other things.
        if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &remember, nullptr);
    }
}

TidyEnd::~TidyEnd() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    const int left = caught;
    caught = 0;
    if (left != 0) std::raise(left);
}

bool interrupted() { return caught != 0; }

void stop_if_interrupted() {
    if (!interrupted()) return;
    caught = 0;
    throw Stop(Status::interrupted, "interrupted");
}

}  // namespace course
