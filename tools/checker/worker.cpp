#include "worker.hpp"

#include <csignal>
#include <cstring>
#include <new>

#include <execinfo.h>
#include <unistd.h>

#include "exercise.hpp"
#include "pipe.hpp"

namespace checker {

namespace {

std::uint64_t call_number = 0;  // the call that is being answered

void reply(Reply kind, const void* data, std::size_t bytes) {
    const Head head{call_number, kind, static_cast<std::uint32_t>(bytes)};
    if (!write_all(answers_fd, &head, sizeof head) || !write_all(answers_fd, data, bytes)) _exit(1);
}

// Only what may be called in a signal handler; `backtrace` has been called once before, which loads
// what it needs.
extern "C" void crashed(int signal) {
    void* trace[64];
    const int size = backtrace(trace, 64);
    // Behind this handler and its trampoline comes the place of the crash; the others are where
    // calls return to, one line too far where a call never does.
    for (int i = 3; i < size; ++i) trace[i] = static_cast<char*>(trace[i]) - 1;
    reply(Reply::crashed, trace, static_cast<std::size_t>(size) * sizeof(void*));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

void catch_crashes() {
    void* trace[1];
    backtrace(trace, 1);
    // A stack of its own, because an endless recursion leaves none.
    static char stack[1 << 16];
    stack_t own{};
    own.ss_sp = stack;
    own.ss_size = sizeof stack;
    sigaltstack(&own, nullptr);
    struct sigaction action {};
    action.sa_handler = crashed;
    action.sa_flags = SA_ONSTACK | SA_RESETHAND | SA_NODEFER;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
        sigaction(signal, &action, nullptr);
}

void answer_one(const Answer& answer, const Numbers& arguments) {
    try {
        const Numbers result = answer(arguments);
        reply(Reply::answer, result.data(), result.size() * sizeof(double));
    } catch (const exercise::NotStarted&) {
        reply(Reply::not_started, nullptr, 0);
    } catch (const std::bad_alloc&) {
        reply(Reply::out_of_memory, nullptr, 0);
    } catch (const std::exception& error) {
        reply(Reply::threw, error.what(), std::strlen(error.what()));
    }
}

}  // namespace

int serve(const Answer& answer) {
    catch_crashes();
    Head head;
    Numbers arguments;
    while (read_all(calls_fd, &head, sizeof head)) {
        arguments.resize(head.bytes / sizeof(double));
        if (!read_all(calls_fd, arguments.data(), head.bytes)) return 1;
        call_number = head.number;
        answer_one(answer, arguments);
    }
    return 0;
}

}  // namespace checker
