#include "worker.hpp"

#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>

#include <cxxabi.h>
#include <execinfo.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include "exercise.hpp"
#include "pipe.hpp"

namespace checker {

namespace {

std::atomic<std::uint64_t> call_number = 0;  // the call that is being answered; 0 before the first
std::atomic<bool> speaking = false;          // a thread may crash while another answers: one after the other

void reply(Reply kind, const void* data, std::size_t bytes) {
    // Who crashes in the midst of this would wait for itself: not for ever.
    for (int turns = 0; speaking.exchange(true) && turns < 100'000; ++turns) sched_yield();
    const Head head{call_number, kind, static_cast<std::uint32_t>(bytes)};
    if (!write_all(answers_fd, &head, sizeof head) || !write_all(answers_fd, data, bytes)) _exit(1);
    if (kind < Reply::not_started) speaking = false;  // the others are last words
}

// Only what may be called in a signal handler. The first `exact` places are as they should be; the
// others are where calls return to, one line too far where a call never does.
void say_last(LastWords& words, int exact) {
    for (int i = exact; i < words.places; ++i) words.place[i] = static_cast<char*>(words.place[i]) - 1;
    reply(Reply::crashed, &words, sizeof words);
}

// Behind the handler and its trampoline comes the place of the crash.
extern "C" void crashed(int signal) {
    LastWords words{};
    words.places = backtrace(words.place, most_places);
    std::strcpy(words.text, sigdescr_np(signal));
    say_last(words, 3);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

// Nothing in the worker catches, so that what the learner's code throws ends here, and the stack is
// still that of the throw.
[[noreturn]] void terminated() {
    LastWords words{};
    words.places = backtrace(words.place, most_places);
    std::strcpy(words.text, "std::terminate was called");
    if (const std::type_info* const type = abi::__cxa_current_exception_type()) {
        try {
            throw;
        } catch (const exercise::NotStarted&) {
            reply(Reply::not_started, nullptr, 0);
            _exit(1);
        } catch (const ArgumentsChanged&) {
            reply(Reply::arguments_changed, nullptr, 0);
            _exit(1);
        } catch (const std::bad_alloc&) {
            reply(Reply::out_of_memory, nullptr, 0);
            _exit(1);
        } catch (const std::exception& error) {
            std::snprintf(words.text, sizeof words.text, "an exception that nobody caught: %s", error.what());
        } catch (...) {
            int status = 0;
            const char* const name = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);  // the process ends
            std::snprintf(words.text, sizeof words.text, "an exception that nobody caught, of type %s",
                          status == 0 ? name : type->name());
        }
    }
    say_last(words, 0);
    _exit(1);
}

void catch_crashes() {
    void* place;
    backtrace(&place, 1);  // which loads what it needs
    // A stack of its own, because an endless recursion leaves none.
    static char stack[1 << 16];
    stack_t own{};
    own.ss_sp = stack;
    own.ss_size = sizeof stack;
    sigaltstack(&own, nullptr);
    struct sigaction action {};
    action.sa_handler = crashed;
    action.sa_flags = SA_ONSTACK | SA_RESETHAND | SA_NODEFER;
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(signal, &action, nullptr);
    std::set_terminate(terminated);
}

// From now on so much work is allowed: a quarter of what all calls may take. A signal ends what takes more.
void begin_work() {
    rlimit all{};
    getrlimit(RLIMIT_CPU, &all);
    const itimerval one{{0, 0}, {static_cast<time_t>(all.rlim_cur / 4), 0}};
    setitimer(ITIMER_PROF, &one, nullptr);
}

// Before the learner's global variables are made. What is printed goes out at once, for the process
// may end at any moment.
[[gnu::constructor(101)]] void get_ready() {
    std::setvbuf(stdout, nullptr, _IONBF, 0);
    catch_crashes();
    begin_work();
}

}  // namespace

int serve(const Answer& answer) {
    reply(Reply::ready, nullptr, 0);
    Head head;
    while (read_all(calls_fd, &head, sizeof head)) {
        call_number = head.number;
        Numbers arguments(head.bytes / sizeof(double));
        if (!read_all(calls_fd, arguments.data(), head.bytes)) return 1;
        begin_work();
        const Numbers result = answer(arguments);
        std::cout.flush();  // it has a buffer of its own after sync_with_stdio(false)
        reply(Reply::answer, result.data(), result.size() * sizeof(double));
    }
    return 0;
}

}  // namespace checker
